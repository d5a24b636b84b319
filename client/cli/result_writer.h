// Results as CSV, JSON or NPY. Thread safety: used by one thread.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"
#include "client/cli/output_file.h"
#include "client/client.h"

namespace gonio::cli {

enum class Format : std::uint8_t { csv, json, npy };

// By name ("csv"), or by a file's extension ("out.npy").
std::optional<Format> format_named(std::string_view name);
std::optional<Format> format_of_file(std::string_view file);

// Puts the input columns of a row, each followed by a comma. `i` counts within the chunk.
template <class T>
using PutInput = std::function<char*(char* out, const client::Chunk<T, T>& chunk, std::size_t i)>;

template <class T>
struct InputColumns {
  std::vector<std::string> names;  // none: the results alone
  PutInput<T> put;
};

// T is float or double: 9 or 17 digits, float32 or float64.
template <class T>
class ResultWriter {
 public:
  virtual ~ResultWriter() = default;
  // The next results.
  virtual Outcome write(const client::Chunk<T, T>& chunk) = 0;
  // What is left to write, also for no pairs at all.
  virtual Outcome finish(const client::Report& report) = 0;
};

// `f_0,...,f_N,flags` and a line for each pair; before them the input's columns, if there are any.
template <class T>
std::unique_ptr<ResultWriter<T>> csv_writer(OutputFile& output, InputColumns<T> input);

// {"channels": N, "values": [[f_0, ...], ...], "flags": [...], "report": {...}}.
template <class T>
std::unique_ptr<ResultWriter<T>> json_writer(OutputFile& output);

// An array of pairs x channels. `pairs`: their number, if it is known; else the output must be
// opened for patch().
template <class T>
std::unique_ptr<ResultWriter<T>> npy_writer(OutputFile& output, std::optional<std::uint64_t> pairs);

}  // namespace gonio::cli
