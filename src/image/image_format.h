// Which file format encoded pixels are in, by their first bytes. Nothing is decoded here.
#pragma once

#include <cstddef>
#include <span>
#include <string>

namespace ribalta {

/// The formats that are decoded.
enum class ImageFormat { kUnknown, kPng, kJpeg, kWebp, kTiff, kOpenExr, kHdr };

/// The format of a whole encoded picture; kUnknown for anything else.
ImageFormat imageFormat(std::span<const std::byte> encoded);

/// What an undecodable file seems to be, for messages: "a GIF picture", "a text or web page", ...
std::string describeUnknownImage(std::span<const std::byte> encoded);

}  // namespace ribalta
