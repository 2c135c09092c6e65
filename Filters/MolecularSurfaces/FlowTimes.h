/**
 * @file FlowTimes.h
 * @brief The time of a flow as the pipeline's time, so that a time slider shows it.
 */
#ifndef isthmus_FlowTimes_h
#define isthmus_FlowTimes_h

#include <vector>

class vtkInformation;

namespace isthmus
{

/// 0 and `steps` more, equally far apart, to `whole` (square angstrom); none for 0 steps, for a
/// whole that is not a positive number, and where `input` has time steps of its own.
std::vector<double> FlowTimes(int steps, double whole, vtkInformation* input);

/// Tells of an output that it can be had at these times. None: takes back what was told before,
/// unless it is what `input` has.
void TellTimes(const std::vector<double>& times, vtkInformation* input, vtkInformation* output);

/// The one of `times` (not empty) nearest to what is asked of `output`, the last where it asks for
/// none.
double TimeAskedFor(const std::vector<double>& times, vtkInformation* output);

}

#endif
