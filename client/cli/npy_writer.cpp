#include "client/cli/result_writer.h"

namespace gonio::cli {
namespace {

// NPY format version 1.0. Its length does not depend on the numbers, so that it can be written over
// later.
std::string npy_header(std::uint64_t pairs, int channels, bool is_f64) {
  constexpr std::size_t kLength = 128;  // a multiple of 64, as the format asks for
  std::string header("\x93NUMPY\x01\x00", 8);
  header += static_cast<char>(kLength - 10);
  header += '\0';
  header += std::string("{'descr': '") + (is_f64 ? "<f8" : "<f4") +
            "', 'fortran_order': False, 'shape': (" + std::to_string(pairs) + ", " +
            std::to_string(channels) + "), }";
  header.resize(kLength - 1, ' ');
  return header + '\n';
}

template <class T>
class NpyWriter final : public ResultWriter<T> {
 public:
  NpyWriter(OutputFile& output, std::optional<std::uint64_t> pairs)
      : output_(output), pairs_(pairs) {}

  Outcome write(const client::Chunk<T, T>& chunk) override {
    if (auto begun = begin(chunk.channels); !begun) return begun;
    return output_.write(
        {reinterpret_cast<const char*>(chunk.values.data()), chunk.values.size_bytes()});
  }

  Outcome finish(const client::Report& report) override {
    if (auto begun = begin(report.channels); !begun) return begun;
    if (pairs_) return Ok{};
    return output_.patch(npy_header(report.pairs, report.channels, sizeof(T) == sizeof(double)));
  }

 private:
  Outcome begin(int channels) {
    if (begun_) return Ok{};
    begun_ = true;
    return output_.write(npy_header(pairs_.value_or(0), channels, sizeof(T) == sizeof(double)));
  }

  OutputFile& output_;
  std::optional<std::uint64_t> pairs_;
  bool begun_ = false;
};

}  // namespace

template <class T>
std::unique_ptr<ResultWriter<T>> npy_writer(OutputFile& output,
                                            std::optional<std::uint64_t> pairs) {
  return std::make_unique<NpyWriter<T>>(output, pairs);
}

template std::unique_ptr<ResultWriter<float>> npy_writer(OutputFile&, std::optional<std::uint64_t>);
template std::unique_ptr<ResultWriter<double>> npy_writer(OutputFile&,
                                                          std::optional<std::uint64_t>);

}  // namespace gonio::cli
