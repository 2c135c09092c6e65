/**
 * @file ReaderGuard.h
 * @brief What the readers' VTK classes do around reading: a file named, errors as sentences and
 * codes.
 */
#ifndef isthmus_ReaderGuard_h
#define isthmus_ReaderGuard_h

#include "AlgorithmGuard.h"
#include "ReaderError.h"

#include <vtkErrorCode.h>

#include <stdexcept>

namespace isthmus
{

/// VTK's error code for each way in which reading a file fails.
inline unsigned long ErrorCodeOf(ReaderFailure kind)
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
 * Runs body() for a reader of `fileName`; what goes wrong becomes a sentence, an empty output (see
 * Guarded) and an error code through setErrorCode(code). Returns what RequestData returns.
 * @throws nothing, whatever body() throws.
 */
template <typename Reader, typename SetErrorCode, typename Body>
int GuardedRead(Reader* reader, const char* fileName, vtkDataObject* output,
  SetErrorCode&& setErrorCode, Body&& body)
{
  return Guarded(reader, output,
    [&]
    {
      setErrorCode(vtkErrorCode::NoError);
      if (!fileName || !*fileName)
      {
        setErrorCode(vtkErrorCode::NoFileNameError);
        throw std::invalid_argument("There is no file to read: set FileName.");
      }
      try
      {
        body();
      }
      catch (const ReaderError& error)
      {
        setErrorCode(ErrorCodeOf(error.Kind));
        throw;
      }
    });
}

}

#endif
