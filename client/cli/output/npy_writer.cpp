#include <utility>

#include "client/cli/output/result_writer.h"

namespace gonio::cli {
namespace {

// NPY format version 1.0. Its length does not depend on the numbers, so that it can be written over
// later.
std::string npy_header(std::uint64_t rows, std::size_t columns, bool is_f64) {
  constexpr std::size_t kLength = 128;  // a multiple of 64, as the format asks for
  std::string header("\x93NUMPY\x01\x00", 8);
  header += static_cast<char>(kLength - 10);
  header += '\0';
  header += std::string("{'descr': '") + (is_f64 ? "<f8" : "<f4") +
            "', 'fortran_order': False, 'shape': (" + std::to_string(rows) + ", " +
            std::to_string(columns) + "), }";
  header.resize(kLength - 1, ' ');
  return header + '\n';
}

template <class T>
class NpyWriter final : public ResultWriter<T> {
 public:
  NpyWriter(OutputFile& output, Table table, std::optional<std::uint64_t> rows)
      : output_(output), table_(std::move(table)), rows_(rows) {}

  Outcome write(const Rows<T>& rows) override {
    if (auto begun = begin(rows.channels); !begun) return begun;
    return output_.write(
        {reinterpret_cast<const char*>(rows.numbers.data()), rows.numbers.size_bytes()});
  }

  Outcome finish(const client::Report& report) override {
    if (auto begun = begin(report.channels); !begun) return begun;
    if (rows_) return Ok{};
    return output_.patch(header(report.pairs, report.channels));
  }

 private:
  Outcome begin(int channels) {
    if (begun_) return Ok{};
    begun_ = true;
    return output_.write(header(rows_.value_or(0), channels));
  }

  [[nodiscard]] std::string header(std::uint64_t rows, int channels) const {
    return npy_header(rows, table_.columns(channels).size(), sizeof(T) == sizeof(double));
  }

  OutputFile& output_;
  Table table_;
  std::optional<std::uint64_t> rows_;
  bool begun_ = false;
};

}  // namespace

template <class T>
std::unique_ptr<ResultWriter<T>> npy_writer(OutputFile& output, Table table,
                                            std::optional<std::uint64_t> rows) {
  return std::make_unique<NpyWriter<T>>(output, std::move(table), rows);
}

template std::unique_ptr<ResultWriter<float>> npy_writer(OutputFile&, Table,
                                                         std::optional<std::uint64_t>);
template std::unique_ptr<ResultWriter<double>> npy_writer(OutputFile&, Table,
                                                          std::optional<std::uint64_t>);

}  // namespace gonio::cli
