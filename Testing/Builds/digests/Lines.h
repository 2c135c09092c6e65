/**
 * @file Lines.h
 * @brief Digests of data objects and files, one line for each array.
 */
#ifndef isthmus_digests_Lines_h
#define isthmus_digests_Lines_h

#include <filesystem>
#include <string>
#include <vector>

class vtkAlgorithm;
class vtkDataObject;

namespace isthmus::digests
{

using Lines = std::vector<std::string>;

/// Appends a line for each array of `object`, its points and its cells included:
/// `output`/PLACE/NAME TYPE COMPONENTS TUPLES DIGEST. The role of an active array follows the
/// digest. Throws std::runtime_error if the type of the object is not supported.
void AddLines(Lines& lines, const std::string& output, vtkDataObject* object);

/// Appends a line for the time steps of an output, if it has any.
void AddTimeSteps(Lines& lines, const std::string& output, vtkAlgorithm* algorithm, int port);

/// Appends a line for the bytes of a file.
void AddFile(Lines& lines, const std::string& output, const std::filesystem::path& file);

/// True if there are no points, cells, rows, vertices or edges.
bool IsEmpty(vtkDataObject* object);

}

#endif
