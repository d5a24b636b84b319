#include <utility>

#include "client/cli/output/numbers.h"
#include "client/cli/output/result_writer.h"

namespace gonio::cli {
namespace {

constexpr std::size_t kBlock = std::size_t{1} << 18;

template <class T>
class CsvWriter final : public ResultWriter<T> {
 public:
  CsvWriter(OutputFile& output, Table table, InputColumns<T> input)
      : output_(output), table_(std::move(table)), input_(std::move(input)) {}

  Outcome write(const Rows<T>& rows) override {
    if (auto begun = begin(rows.channels); !begun) return begun;
    const std::size_t longest_row = (columns_ + input_.names.size() + 1) * (kLongestNumber + 1);
    buffer_.resize(kBlock + longest_row);
    char* at = buffer_.data();
    for (std::size_t i = 0; i < rows.count; ++i) {
      at = put_row(at, rows, i);
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
    const auto columns = table_.columns(channels);
    columns_ = columns.size();
    for (const std::string& name : columns) header += name + ",";
    return output_.write(header + "flags\n");
  }

  char* put_row(char* at, const Rows<T>& rows, std::size_t i) {
    if (input_.put) at = input_.put(at, rows, i);
    for (std::size_t c = 0; c < columns_; ++c) {
      at = put_number(at, rows.numbers[i * columns_ + c]);
      *at++ = ',';
    }
    at = std::to_chars(at, at + kLongestNumber, static_cast<unsigned>(rows.flags[i])).ptr;
    *at++ = '\n';
    return at;
  }

  Outcome flush(const char* end) {
    return output_.write({buffer_.data(), static_cast<std::size_t>(end - buffer_.data())});
  }

  OutputFile& output_;
  Table table_;
  InputColumns<T> input_;
  std::string buffer_;
  std::size_t columns_ = 0;
  bool begun_ = false;
};

}  // namespace

template <class T>
std::unique_ptr<ResultWriter<T>> csv_writer(OutputFile& output, Table table,
                                            InputColumns<T> input) {
  return std::make_unique<CsvWriter<T>>(output, std::move(table), std::move(input));
}

template std::unique_ptr<ResultWriter<float>> csv_writer(OutputFile&, Table, InputColumns<float>);
template std::unique_ptr<ResultWriter<double>> csv_writer(OutputFile&, Table, InputColumns<double>);

}  // namespace gonio::cli
