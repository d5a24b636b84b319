// Measured reflectance from a file, as a fit takes it: MERL, Cornell, ALTA, CSV or NPY. Thread
// safety: used by one thread.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "client/cli/input/byte_source.h"
#include "gonio/base/result.h"
#include "gonio/client/fit.h"

namespace gonio::cli {

struct MeasuredInput {
  int channels = 0;
  std::vector<float> wi, wo, values, weights;  // as client::FitData has them
  std::optional<client::Material> measured;    // in their place
  std::size_t raised = 0;  // of the values: those below 0 that the reader set to 0

  [[nodiscard]] client::FitData data() const {
    return {wi, wo, values, channels, weights, measured};
  }
};

// "746 values below 0 set to 0 (colours that sRGB cannot show)"; empty where there are none.
std::string raised_text(const MeasuredInput& input);

// By the file's content where that says what it is (input/file_kind.h), else by its extension:
// .binary is MERL, .brdf Cornell's text, .dat or .alta ALTA's, .bsdf RGL's; anything else is CSV or
// NPY. Without weights of its own a goniometer's data are weighed by the directions that they stand
// for (measured/solid_angle.h).
// `keep_tables`: a MERL file stays a file for an embedded server to read; otherwise its cells
// become pairs. `degrees`: a CSV's angles are.
Result<MeasuredInput> read_measured(const std::string& file, bool keep_tables, bool degrees);

// The same; or, not `embedded`, the name of one of a server's materials: no extension and no such
// file here.
Result<MeasuredInput> read_data(const std::string& data, bool embedded, bool degrees);

// CSV: the header names wi_x,...,wo_z or theta_i,phi_i,theta_o,phi_o; f_0, f_1, ... (1 to 64); and,
// if there is one, weight. Other columns are ignored; a pair that `flags` marks has no value.
Result<MeasuredInput> read_measured_csv(ByteSource source, bool degrees);

// NPY: a row is wi_x, wi_y, wi_z, wo_x, wo_y, wo_z and 1 to 64 values.
Result<MeasuredInput> read_measured_npy(ByteSource source);

}  // namespace gonio::cli
