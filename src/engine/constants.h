// A prepared lobe: what a kernel reads. Plain data, laid out alike for every instruction set.
#pragma once

#include "engine/material.h"

namespace gonio {

template <class Kind>
struct Constants {
  typename Kind::template Shape<double> shape;
  int channels;
  typename Kind::template Channel<double> channel[kMaxChannels];
};

struct MeasuredConstants {
  const float* table;  // MeasuredTable::data()
};

}  // namespace gonio
