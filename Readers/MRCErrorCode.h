/**
 * @file MRCErrorCode.h
 * @brief VTK's error code for each way in which reading a file fails.
 */
#ifndef isthmus_MRCErrorCode_h
#define isthmus_MRCErrorCode_h

#include "MRCError.h"

#include <vtkErrorCode.h>

namespace isthmus
{

inline unsigned long ErrorCodeOf(MRCFailure kind)
{
  switch (kind)
  {
    case MRCFailure::NoSuchFile:
      return vtkErrorCode::FileNotFoundError;
    case MRCFailure::CannotRead:
      return vtkErrorCode::CannotOpenFileError;
    case MRCFailure::NotAMap:
      return vtkErrorCode::UnrecognizedFileTypeError;
    case MRCFailure::Truncated:
      return vtkErrorCode::PrematureEndOfFileError;
    case MRCFailure::Damaged:
      return vtkErrorCode::FileFormatError;
    case MRCFailure::BadRequest:
      break;
  }
  return vtkErrorCode::UserError;
}

}

#endif
