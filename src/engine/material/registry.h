// The registry's entries with all that they do, for the engine. Thread safety: constant data.
#pragma once

#include "kernels/part.h"

namespace gonio {

// The entry of one of models().
const PartModel& part_model(const ModelDescription& model);

// The part that a checked lobe of an analytic model describes.
Part make_part(const CheckedLobe& lobe, int channels);

// Its derivative by the parameter `by`: kernels for Precision::reference only.
Part make_derivative(const CheckedLobe& lobe, int channels, std::string_view by);

}  // namespace gonio
