#include "client/picture/image/exr.h"

#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfIO.h>
#include <ImfInputFile.h>
#include <ImfOutputFile.h>

#include <array>
#include <cstddef>
#include <exception>
#include <span>
#include <utility>

#include "client/picture/image/read.h"
#include "gonio/base/shown.h"

namespace gonio::image {
namespace {

constexpr std::array<const char*, 3> kNames = {"R", "G", "B"};

// Where the library writes: memory, so that the file itself appears complete or not at all.
class MemoryStream : public Imf::OStream {
 public:
  MemoryStream() : Imf::OStream("memory") {}
  void write(const char* bytes, int count) override {
    bytes_.replace(at_, static_cast<std::size_t>(count), bytes, static_cast<std::size_t>(count));
    at_ += static_cast<std::size_t>(count);
  }
  uint64_t tellp() override { return at_; }
  void seekp(uint64_t position) override { at_ = position; }
  std::string take() { return std::move(bytes_); }

 private:
  std::string bytes_;
  std::size_t at_ = 0;
};

// `names`: the file's channels for red, green and blue, or the one of a grey picture. The library's
// interface wants a pointer without const also for what it only reads.
Imf::FrameBuffer frame_buffer(const Image& image, std::span<const char* const> names,
                              const Imath::Box2i& window) {
  Imf::FrameBuffer buffer;
  const std::size_t row = sizeof(Rgb) * static_cast<std::size_t>(image.width);
  for (std::size_t i = 0; i < names.size(); ++i) {
    auto* first = const_cast<float*>(image.pixels.front().data() + i);
    buffer.insert(names[i], Imf::Slice::Make(Imf::FLOAT, first, window, sizeof(Rgb), row));
  }
  return buffer;
}

Outcome check_header(const std::string& file, const Imf::Header& header) {
  const auto& window = header.dataWindow();
  const auto& display = header.displayWindow();
  if (window != display) return bad_value(file, "a cropped picture", "one that has all its pixels");
  return check_size(file, static_cast<std::int64_t>(window.max.x) - window.min.x + 1,
                    static_cast<std::int64_t>(window.max.y) - window.min.y + 1);
}

Result<bool> is_grey(const std::string& file, const Imf::ChannelList& channels) {
  const auto whole = [&](const char* name) {
    const Imf::Channel* channel = channels.findChannel(name);
    return channel != nullptr && channel->xSampling == 1 && channel->ySampling == 1;
  };
  if (whole("R") && whole("G") && whole("B")) return false;
  if (whole("Y") && channels.findChannel("RY") == nullptr) return true;
  std::string names;
  for (auto at = channels.begin(); at != channels.end(); ++at) {
    names += (names.empty() ? "" : ", ") + std::string(at.name());
  }
  return bad_value(file, "a picture of the channels " + names, "R, G and B, or Y alone");
}

Result<Image> read_first_part(const std::string& file) {
  Imf::InputFile input(file.c_str());
  const Imf::Header& header = input.header();
  if (auto fits = check_header(file, header); !fits) return fits.error();
  auto grey = is_grey(file, header.channels());
  if (!grey) return grey.error();
  if (!input.isComplete()) {
    return Error{
        ErrorCode::data_loss, shown(file) + " is truncated: rows are missing", shown(file), {}, {}};
  }
  const auto& window = header.dataWindow();
  Image image(window.max.x - window.min.x + 1, window.max.y - window.min.y + 1);
  const std::array<const char*, 1> luminance = {"Y"};
  input.setFrameBuffer(*grey ? frame_buffer(image, luminance, window)
                             : frame_buffer(image, kNames, window));
  input.readPixels(window.min.y, window.max.y);
  if (!*grey) return image;
  for (Rgb& pixel : image.pixels) pixel = Rgb::Constant(pixel[0]);
  return image;
}

}  // namespace

Result<std::string> encode_exr(const Image& image) try {
  Imf::Header header(image.width, image.height);
  for (const char* name : kNames) header.channels().insert(name, Imf::Channel(Imf::FLOAT));
  MemoryStream stream;
  {
    Imf::OutputFile output(stream, header);
    output.setFrameBuffer(frame_buffer(image, kNames, header.dataWindow()));
    output.writePixels(image.height);
  }  // the table of rows is written when the file closes
  return stream.take();
} catch (const std::exception& error) {
  return Error{ErrorCode::internal,
               std::string("no OpenEXR file could be made: ") + error.what(),
               {},
               {},
               {}};
}

Result<Image> read_exr(const std::string& file) try {
  return read_first_part(file);
} catch (const std::exception& error) {
  return Error{ErrorCode::data_loss,
               shown(file + " cannot be read as OpenEXR: " + error.what()),
               shown(file),
               {},
               {}};
}

}  // namespace gonio::image
