#include <utility>

#include "client/cli/numbers.h"
#include "client/cli/result_writer.h"

namespace gonio::cli {
namespace {

constexpr std::size_t kBlock = std::size_t{1} << 18;

template <class T>
class CsvWriter final : public ResultWriter<T> {
 public:
  CsvWriter(OutputFile& output, InputColumns<T> input)
      : output_(output), input_(std::move(input)) {}

  Outcome write(const client::Chunk<T, T>& chunk) override {
    if (auto begun = begin(chunk.channels); !begun) return begun;
    const auto channels = static_cast<std::size_t>(chunk.channels);
    const std::size_t longest_row = (channels + input_.names.size() + 1) * (kLongestNumber + 1);
    buffer_.resize(kBlock + longest_row);
    char* at = buffer_.data();
    for (std::size_t i = 0; i < chunk.pairs; ++i) {
      at = put_row(at, chunk, i, channels);
      if (static_cast<std::size_t>(at - buffer_.data()) < kBlock) continue;
      if (auto written = flush(at); !written) return written;
      at = buffer_.data();
    }
    return flush(at);
  }

  Outcome finish(const client::Report& report) override { return begin(report.channels); }

 private:
  Outcome begin(int channels) {
    if (begun_) return Ok{};
    begun_ = true;
    std::string header;
    for (const std::string& name : input_.names) header += name + ",";
    for (int c = 0; c < channels; ++c) header += "f_" + std::to_string(c) + ",";
    return output_.write(header + "flags\n");
  }

  char* put_row(char* at, const client::Chunk<T, T>& chunk, std::size_t i, std::size_t channels) {
    if (input_.put) at = input_.put(at, chunk, i);
    for (std::size_t c = 0; c < channels; ++c) {
      at = put_number(at, chunk.values[i * channels + c]);
      *at++ = ',';
    }
    at = std::to_chars(at, at + kLongestNumber, static_cast<unsigned>(chunk.flags[i])).ptr;
    *at++ = '\n';
    return at;
  }

  Outcome flush(const char* end) {
    return output_.write({buffer_.data(), static_cast<std::size_t>(end - buffer_.data())});
  }

  OutputFile& output_;
  InputColumns<T> input_;
  std::string buffer_;
  bool begun_ = false;
};

}  // namespace

template <class T>
std::unique_ptr<ResultWriter<T>> csv_writer(OutputFile& output, InputColumns<T> input) {
  return std::make_unique<CsvWriter<T>>(output, std::move(input));
}

template std::unique_ptr<ResultWriter<float>> csv_writer(OutputFile&, InputColumns<float>);
template std::unique_ptr<ResultWriter<double>> csv_writer(OutputFile&, InputColumns<double>);

}  // namespace gonio::cli
