/**
 * @file DiphaFiles.h
 * @brief Volumes and persistence diagrams in DIPHA's format, as other programs read and write them.
 *
 * Format: U. Bauer, M. Kerber, J. Reininghaus, DIPHA, README: 64-bit little-endian integers (magic
 * 8067171840, type 1 image data, number of values, number of axes, sizes; or type 2 persistence
 * diagram, number of pairs) and doubles; x fastest. It needs nothing but the standard library.
 */
#ifndef isthmus_DiphaFiles_h
#define isthmus_DiphaFiles_h

#include <array>
#include <cstdint>
#include <fstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace isthmus::testing
{

struct DiphaImage
{
  std::array<std::int64_t, 3> Dimensions{ 0, 0, 0 };
  std::vector<double> Values;
};

struct DiphaPair
{
  std::int64_t Dimension;
  double Birth;
  double Death;
};
using DiphaPairs = std::vector<DiphaPair>;

constexpr std::int64_t DiphaMagic = 8067171840;

template <typename T>
void WriteRaw(std::ofstream& file, const T* values, std::size_t count)
{
  file.write(
    reinterpret_cast<const char*>(values), static_cast<std::streamsize>(count * sizeof(T)));
}

template <typename T>
void ReadRaw(std::ifstream& file, T* values, std::size_t count, const std::string& name)
{
  if (!file.read(reinterpret_cast<char*>(values), static_cast<std::streamsize>(count * sizeof(T))))
  {
    throw std::runtime_error(name + " ends too early, or is not there.");
  }
}

inline void WriteDiphaImage(const std::string& name, const DiphaImage& image)
{
  std::ofstream file(name, std::ios::binary);
  const auto& n = image.Dimensions;
  const std::int64_t header[] = { DiphaMagic, 1, n[0] * n[1] * n[2], 3, n[0], n[1], n[2] };
  WriteRaw(file, header, 7);
  WriteRaw(file, image.Values.data(), image.Values.size());
  if (!file.flush())
  {
    throw std::runtime_error(name + " cannot be written.");
  }
}

inline DiphaImage ReadDiphaImage(const std::string& name)
{
  std::ifstream file(name, std::ios::binary);
  std::int64_t header[7];
  ReadRaw(file, header, 7, name);
  if (header[0] != DiphaMagic || header[1] != 1 || header[3] != 3)
  {
    throw std::runtime_error(name + " is not a volume in DIPHA's format.");
  }
  DiphaImage image{ { header[4], header[5], header[6] }, {} };
  image.Values.resize(static_cast<std::size_t>(header[2]));
  ReadRaw(file, image.Values.data(), image.Values.size(), name);
  return image;
}

inline void WriteDiphaPairs(const std::string& name, const DiphaPairs& pairs)
{
  std::ofstream file(name, std::ios::binary);
  const std::int64_t header[] = { DiphaMagic, 2, static_cast<std::int64_t>(pairs.size()) };
  WriteRaw(file, header, 3);
  WriteRaw(file, pairs.data(), pairs.size());
  if (!file.flush())
  {
    throw std::runtime_error(name + " cannot be written.");
  }
}

inline DiphaPairs ReadDiphaPairs(const std::string& name)
{
  std::ifstream file(name, std::ios::binary);
  std::int64_t header[3];
  ReadRaw(file, header, 3, name);
  if (header[0] != DiphaMagic || header[1] != 2)
  {
    throw std::runtime_error(name + " is not a persistence diagram in DIPHA's format.");
  }
  DiphaPairs pairs(static_cast<std::size_t>(header[2]));
  ReadRaw(file, pairs.data(), pairs.size(), name);
  return pairs;
}

}

#endif
