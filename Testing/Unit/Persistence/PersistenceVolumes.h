/**
 * @file PersistenceVolumes.h
 * @brief Volumes for the tests and the benchmark of persistence: smooth, of atoms, noise, maps.
 */
#ifndef isthmus_PersistenceVolumes_h
#define isthmus_PersistenceVolumes_h

#include "Persistence/VolumeView.h"
#include "SharedData.h"

#include <vtkDataArray.h>
#include <vtkImageData.h>
#include <vtkMRCMapReader.h>
#include <vtkNew.h>
#include <vtkPointData.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <random>
#include <string>
#include <vector>

namespace isthmus::testing
{

using Size = std::array<std::int64_t, 3>;

template <typename T>
struct Volume
{
  Size Dimensions{ 0, 0, 0 };
  std::vector<T> Values;

  VolumeView View() const { return VolumeView(this->Values.data(), this->Dimensions); }
};

/// f(i, j, k) at each node, x fastest.
template <typename T, typename Function>
Volume<T> Fill(const Size& n, Function&& f)
{
  Volume<T> volume{ n, {} };
  volume.Values.reserve(static_cast<std::size_t>(n[0] * n[1] * n[2]));
  for (std::int64_t k = 0; k < n[2]; ++k)
  {
    for (std::int64_t j = 0; j < n[1]; ++j)
    {
      for (std::int64_t i = 0; i < n[0]; ++i)
      {
        volume.Values.push_back(static_cast<T>(
          f(static_cast<double>(i), static_cast<double>(j), static_cast<double>(k))));
      }
    }
  }
  return volume;
}

/// Smooth, with pits, tunnels and hollows about ten nodes apart.
inline double Wave(double x, double y, double z)
{
  return std::sin(0.31 * x) * std::cos(0.23 * y) + std::sin(0.17 * y + 1.0) * std::cos(0.29 * z) +
    std::sin(0.27 * z) * std::cos(0.19 * x + 0.5);
}

/// About five nodes apart, for small volumes.
inline double ShortWave(double x, double y, double z)
{
  return Wave(2.0 * x, 2.0 * y, 2.0 * z);
}

/// Whole numbers, each drawn independently.
template <typename T>
Volume<T> Noise(const Size& n, double low, double high, unsigned seed = 7)
{
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> value(low, high);
  return Fill<T>(n, [&](double, double, double) { return std::floor(value(random)); });
}

/// Distance from the nearest of `count` atoms drawn in the box, as far as 24 nodes.
inline Volume<float> AtomDistance(const Size& n, int count, unsigned seed)
{
  constexpr std::int64_t reach = 24;
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> place(0.0, 1.0);
  Volume<float> volume = Fill<float>(n, [](double, double, double) { return 2.0 * reach; });
  for (int i = 0; i < count; ++i)
  {
    std::array<double, 3> atom{};
    Size low{};
    Size high{};
    for (std::size_t a = 0; a < 3; ++a)
    {
      atom[a] = place(random) * static_cast<double>(n[a]);
      low[a] = std::max<std::int64_t>(0, static_cast<std::int64_t>(atom[a]) - reach);
      high[a] = std::min<std::int64_t>(n[a] - 1, static_cast<std::int64_t>(atom[a]) + reach);
    }
    for (std::int64_t z = low[2]; z <= high[2]; ++z)
    {
      for (std::int64_t y = low[1]; y <= high[1]; ++y)
      {
        for (std::int64_t x = low[0]; x <= high[0]; ++x)
        {
          const double d = std::hypot(static_cast<double>(x) - atom[0],
            static_cast<double>(y) - atom[1], static_cast<double>(z) - atom[2]);
          float& value = volume.Values[static_cast<std::size_t>(x + n[0] * (y + n[1] * z))];
          value = std::min(value, static_cast<float>(d));
        }
      }
    }
  }
  return volume;
}

/// A map as our reader reads it; empty where it refuses.
inline Volume<float> ReadMap(const std::filesystem::path& path)
{
  vtkNew<vtkMRCMapReader> reader;
  reader->GlobalWarningDisplayOff();
  reader->SetFileName(path.string().c_str());
  reader->Update();
  vtkImageData* image = reader->GetOutput();
  vtkDataArray* scalars = image->GetPointData()->GetScalars();
  const int* n = image->GetDimensions();
  Volume<float> map{ { n[0], n[1], n[2] }, {} };
  for (vtkIdType i = 0; scalars && i < scalars->GetNumberOfTuples(); ++i)
  {
    map.Values.push_back(static_cast<float>(scalars->GetComponent(i, 0)));
  }
  return map;
}

/// The files of the shared maps, by name.
inline std::vector<std::filesystem::path> SharedMapFiles()
{
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(SharedDataFolder() / "maps"))
  {
    if (entry.is_regular_file() && entry.path().extension() != ".cube")
    {
      files.push_back(entry.path());
    }
  }
  std::sort(files.begin(), files.end());
  return files;
}

/// At most 128 nodes per side.
inline bool IsSmall(const Volume<float>& map)
{
  const Size& n = map.Dimensions;
  return !map.Values.empty() && n[0] <= 128 && n[1] <= 128 && n[2] <= 128;
}

}

#endif
