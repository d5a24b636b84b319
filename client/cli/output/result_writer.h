// Results as CSV, JSON or NPY. Thread safety: used by one thread.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "client/cli/output/output_file.h"
#include "gonio/base/result.h"
#include "gonio/client/client.h"

namespace gonio::cli {

enum class Format : std::uint8_t { csv, json, npy };

// By name ("csv"), or by a file's extension ("out.npy").
std::optional<Format> format_named(std::string_view name);
std::optional<Format> format_of_file(std::string_view file);

// A run of results, as rows of numbers.
template <class T>
struct Rows {
  std::uint64_t first = 0;  // the number of its first row
  std::size_t count = 0;
  int channels = 0;
  std::span<const T> numbers;           // count x the table's columns
  std::span<const std::uint8_t> flags;  // one byte a row
  std::span<const T> wi, wo;            // of each pair, as the source gave them, or empty
};

// What the rows hold.
struct Table {
  // The columns' names.
  std::function<std::vector<std::string>(int channels)> columns;
  // Whether JSON says the columns' names: for rows of more than one kind of number.
  bool is_mixed = false;
  // Samples rather than the values of pairs: how JSON calls them, and that some may be lost.
  bool of_samples = false;
};

// "f_0", ..., "f_2", as the columns of so many channels.
std::vector<std::string> channel_names(const std::string& letter, int channels);

// Puts the input columns of a row, each followed by a comma. `i` counts within the rows.
template <class T>
using PutInput = std::function<char*(char* out, const Rows<T>& rows, std::size_t i)>;

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
  virtual Outcome write(const Rows<T>& rows) = 0;
  // What is left to write, also for no rows at all.
  virtual Outcome finish(const client::Report& report) = 0;
};

// `f_0,...,f_N,flags` and a line for each row; before them the input's columns, if there are any.
template <class T>
std::unique_ptr<ResultWriter<T>> csv_writer(OutputFile& output, Table table, InputColumns<T> input);

// {"channels": N, "values": [[f_0, ...], ...], "flags": [...], "report": {...}}.
template <class T>
std::unique_ptr<ResultWriter<T>> json_writer(OutputFile& output, Table table);

// An array of rows x columns. `rows`: their number, if it is known; else the output must be opened
// for patch().
template <class T>
std::unique_ptr<ResultWriter<T>> npy_writer(OutputFile& output, Table table,
                                            std::optional<std::uint64_t> rows);

// The one for a format; `input` is for CSV.
template <class T>
std::unique_ptr<ResultWriter<T>> make_writer(Format format, OutputFile& output, Table table,
                                             std::optional<std::uint64_t> rows,
                                             InputColumns<T> input);

}  // namespace gonio::cli
