// The names of an animation's frames, and which of them are there already.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "animation_options.h"
#include "render/read_frame.h"

namespace ribalta {

/// ".png" of "shot.PNG": what says the format, in lower case.
std::string endingOf(const std::filesystem::path& path);

/// Whether the ending is that of a film: .mp4, .webm or .mkv, in either case.
bool isVideo(const std::filesystem::path& path);

/// The picture's name with the frame's number in the place of the last run of # in the file's name,
/// with at least as many digits; without any, "_0001" before the ending.
std::filesystem::path numbered(const std::filesystem::path& picture, int frame);

/// All that a range of frames is written to. Throws Error(kUsage) where two of them are one file.
std::vector<std::filesystem::path> allFrameFiles(const std::vector<std::filesystem::path>& outputs,
                                                 const FrameRange& range);

/// When the newest of these files was written; long ago where none of them is there.
std::filesystem::file_time_type newestOf(const std::vector<std::filesystem::path>& files);

/// Whether the file is a .png or .exr of this size from its first byte to its last; an .exr with
/// these layers.
bool isWholePicture(const std::filesystem::path& path, int width, int height,
                    const FrameLayers& layers);

}  // namespace ribalta
