#include "client/picture/image/pfm.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <vector>

#include "client/picture/image/read.h"
#include "gonio/base/shown.h"

namespace gonio::image {
namespace {

struct Header {
  int width = 0, height = 0;
  std::size_t channels = 3;
  bool little_endian = true;
};

Error broken(const std::string& file, const std::string& what) {
  return {
      ErrorCode::data_loss, shown(file) + " cannot be read as PFM: " + what, shown(file), {}, {}};
}

Result<Header> read_header(const std::string& file, std::ifstream& in) {
  std::array<char, 2> magic{};
  in.read(magic.data(), magic.size());
  Header header;
  if (in.gcount() != 2 || magic[0] != 'P' || (magic[1] != 'F' && magic[1] != 'f')) {
    return broken(file, "it does not begin with PF or Pf");
  }
  header.channels = magic[1] == 'F' ? 3 : 1;
  std::int64_t width = 0, height = 0;
  double scale = 0;
  // One character, a line's end, stands between the scale and the first row.
  if (!(in >> width >> height >> scale) || in.get() == std::ifstream::traits_type::eof()) {
    return broken(file, "its header has no width, height and scale");
  }
  if (scale == 0) return broken(file, "its scale is 0, which says nothing of the order of bytes");
  if (auto fits = check_size(file, width, height); !fits) return fits.error();
  header.width = static_cast<int>(width);
  header.height = static_cast<int>(height);
  header.little_endian = scale < 0;
  return header;
}

float swapped(float value) {
  return std::bit_cast<float>(__builtin_bswap32(std::bit_cast<std::uint32_t>(value)));
}

}  // namespace

Result<Image> read_pfm(const std::string& file) {
  std::ifstream in(file, std::ios::binary);
  if (!in) return broken(file, std::strerror(errno));
  auto header = read_header(file, in);
  if (!header) return header.error();
  Image image(header->width, header->height);
  const bool swap = header->little_endian != (std::endian::native == std::endian::little);
  std::vector<float> row(header->channels * static_cast<std::size_t>(header->width));
  const auto bytes = static_cast<std::streamsize>(sizeof(float) * row.size());
  for (int y = image.height - 1; y >= 0; --y) {
    in.read(reinterpret_cast<char*>(row.data()), bytes);
    if (in.gcount() != bytes) {
      return broken(file, "it is truncated: " + std::to_string(y + 1) + " of " +
                              std::to_string(image.height) + " rows are missing");
    }
    if (swap) std::transform(row.begin(), row.end(), row.begin(), swapped);
    for (int x = 0; x < image.width; ++x) {
      const float* texel = row.data() + header->channels * static_cast<std::size_t>(x);
      image.at(x, y) =
          header->channels == 3 ? Rgb(texel[0], texel[1], texel[2]) : Rgb::Constant(texel[0]);
    }
  }
  return image;
}

}  // namespace gonio::image
