#include "client/cli/output/result_writer.h"

#include <cctype>
#include <utility>

namespace gonio::cli {

std::optional<Format> format_named(std::string_view name) {
  if (name == "csv") return Format::csv;
  if (name == "json") return Format::json;
  if (name == "npy") return Format::npy;
  return std::nullopt;
}

std::optional<Format> format_of_file(std::string_view file) {
  const std::size_t dot = file.rfind('.');
  if (dot == std::string_view::npos) return std::nullopt;
  std::string extension(file.substr(dot + 1));
  for (char& c : extension) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return format_named(extension);
}

std::vector<std::string> channel_names(const std::string& letter, int channels) {
  std::vector<std::string> names;
  for (int c = 0; c < channels; ++c) names.push_back(letter + "_" + std::to_string(c));
  return names;
}

template <class T>
std::unique_ptr<ResultWriter<T>> make_writer(Format format, OutputFile& output, Table table,
                                             std::optional<std::uint64_t> rows,
                                             InputColumns<T> input) {
  switch (format) {
    case Format::json:
      return json_writer<T>(output, std::move(table));
    case Format::npy:
      return npy_writer<T>(output, std::move(table), rows);
    case Format::csv:
      break;
  }
  return csv_writer<T>(output, std::move(table), std::move(input));
}

template std::unique_ptr<ResultWriter<float>> make_writer(Format, OutputFile&, Table,
                                                          std::optional<std::uint64_t>,
                                                          InputColumns<float>);
template std::unique_ptr<ResultWriter<double>> make_writer(Format, OutputFile&, Table,
                                                           std::optional<std::uint64_t>,
                                                           InputColumns<double>);

}  // namespace gonio::cli
