/**
 * @file ReaderGuard.h
 * @brief Steps that the VTK classes of readers perform around reading: checking the file name, and
 * reporting errors as messages and codes.
 */
#ifndef isthmus_ReaderGuard_h
#define isthmus_ReaderGuard_h

#include "Core/AlgorithmGuard.h"
#include "Files/ReaderError.h"

#include <vtkErrorCode.h>

#include <filesystem>
#include <stdexcept>
#include <system_error>

namespace isthmus
{

/// VTK's error code for each way in which reading a file fails.
inline unsigned long ToErrorCode(ReaderFailure kind)
{
  switch (kind)
  {
    case ReaderFailure::NoSuchFile:
      return vtkErrorCode::FileNotFoundError;
    case ReaderFailure::CannotRead:
      return vtkErrorCode::CannotOpenFileError;
    case ReaderFailure::ForeignFormat:
      return vtkErrorCode::UnrecognizedFileTypeError;
    case ReaderFailure::Truncated:
      return vtkErrorCode::PrematureEndOfFileError;
    case ReaderFailure::Damaged:
      return vtkErrorCode::FileFormatError;
    case ReaderFailure::BadRequest:
      break;
  }
  return vtkErrorCode::UserError;
}

/**
 * The result of CanReadFile for a file; looks(fileName) decides whether the content is that of the
 * reader's format.
 *
 * Empty files, folders and pipes have no content to judge. For these the extension decides, by
 * which ParaView has chosen the reader, and reading reports what is wrong. If all readers refused
 * them, ParaView would offer them to readers that wait for pipes or crash on empty files.
 */
template <typename Looks>
int CanRead(const char* fileName, Looks&& looks)
{
  if (!fileName)
  {
    return 0;
  }
  std::error_code failed;
  const auto status = std::filesystem::status(fileName, failed);
  const bool isNamed =
    !failed && std::filesystem::exists(status) && std::filesystem::path(fileName).has_extension();
  if (isNamed &&
    (!std::filesystem::is_regular_file(status) || std::filesystem::is_empty(fileName, failed)))
  {
    return 1;
  }
  return looks(fileName) ? 1 : 0;
}

/**
 * Runs body() for a reader of `fileName`; failures become a message, an empty output (see
 * RunGuarded) and an error code. `setErrorCode(code)` is called only if the code changes, since
 * that marks the reader as modified and makes it read again. Returns the value for RequestData.
 * @throws nothing, whatever body() throws.
 */
template <typename Reader, typename SetErrorCode, typename Body>
int ReadGuarded(Reader* reader, const char* fileName, vtkDataObject* output,
  SetErrorCode&& setErrorCode, Body&& body)
{
  const auto ends = [&](unsigned long code)
  {
    if (reader->GetErrorCode() != code)
    {
      setErrorCode(code);
    }
  };
  return RunGuarded(reader, output,
    [&]
    {
      if (!fileName || !*fileName)
      {
        ends(vtkErrorCode::NoFileNameError);
        throw std::invalid_argument("There is no file to read: set FileName.");
      }
      try
      {
        body();
        ends(vtkErrorCode::NoError);
      }
      catch (const Cancelled&)
      {
        ends(vtkErrorCode::NoError);
        throw;
      }
      catch (const ReaderError& error)
      {
        ends(ToErrorCode(error.Kind));
        throw;
      }
      catch (const std::exception&)
      {
        ends(vtkErrorCode::FileFormatError);
        throw;
      }
    });
}

}

#endif
