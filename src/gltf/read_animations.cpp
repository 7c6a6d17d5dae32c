#include "gltf/read_animations.h"

#include <cmath>
#include <cstdio>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "gltf/aim_channel.h"
#include "gltf/animation_pointer.h"
#include "gltf/bad_input.h"
#include "gltf/check_motion.h"
#include "gltf/read_sampler.h"
#include "gltf/tally.h"
#include "gltf/where.h"

namespace ribalta::gltf {
namespace {

using nlohmann::json;
using Part = AnimationChannel::Part;

constexpr const char* kLeftOut = "; the channels that use this are left out";

// What a channel moves: two of one animation must not have it in common.
using Moved = std::tuple<int, Part, int>;

Moved movedBy(const AnimationChannel& channel) {
    return {channel.mover, channel.part, channel.first};
}

std::string shown(double number) {
    char text[32];
    std::snprintf(text, sizeof text, "%.4g", number);
    return text;
}

class Reader {
  public:
    Reader(const Import& import, const NodeList& list, Scene& scene, Report& report)
        : import_(import),
          list_(list),
          scene_(scene),
          report_(report),
          aimer_(import, list, scene),
          samplers_(import, report) {}

    std::vector<DialSource> readAll();

  private:
    struct Source {
        const json& text;
        const Where& where;
        std::map<std::pair<std::size_t, SamplerUse>, int> samplers;  ///< by index and meaning
        std::set<Moved> moved;
    };

    void readChannel(Source& source, std::size_t index, Animation& animation);
    int samplerOf(Source& source, std::size_t index, const SamplerUse& use, Animation& animation);
    void checkRange(const AnimationChannel& channel, const AnimationSampler& sampler,
                    const Place& place);
    void hintAtRivals();

    const Import& import_;
    const NodeList& list_;
    Scene& scene_;
    Report& report_;
    Aimer aimer_;
    SamplerReader samplers_;
};

std::vector<DialSource> Reader::readAll() {
    const json& animations = member(import_.json, "animations");
    const Where root(import_.file);
    const Where where(root, "animations");
    for (std::size_t i = 0; i < animations.size(); ++i) {
        const json& animation = animations[i];
        const json& name = member(animation, "name");
        Animation& read = scene_.animations.emplace_back();
        read.name = name.is_string() ? name.get<std::string>() : "";
        const Where here(where, i);
        Source source{animation, here, {}, {}};
        const std::size_t count = member(animation, "channels").size();
        for (std::size_t c = 0; c < count; ++c) {
            readChannel(source, c, read);
        }
    }
    aimer_.tell(report_);
    samplers_.tell();
    hintAtRivals();
    if (const std::optional<std::size_t> node = movesOutOfBounds(scene_, list_.nodes)) {
        report_.ignored(where.place(),
                        "may take node " + std::to_string(list_.gltfNodes[*node]) +
                            " out of all bounds, together with its parents; nothing is played");
        for (Animation& animation : scene_.animations) {
            animation.channels.clear();
        }
        scene_.movers.clear();
    }
    return aimer_.dialSources();
}

void Reader::readChannel(Source& source, std::size_t index, Animation& animation) {
    const json& channel = source.text["channels"][index];
    if (channel.is_null()) {
        return;  // told already
    }
    const Where channels(source.where, "channels");
    const Where here(channels, index);
    const Where targetWhere(here, "target");
    const json& target = channel["target"];
    if (!aimer_.knowsPath(target, targetWhere)) {
        return;
    }
    const auto samplerIndex = channel["sampler"].get<std::size_t>();
    const json& samplers = source.text["samplers"];
    if (samplerIndex >= samplers.size()) {
        report_.ignored(Where(here, "sampler").place(),
                        "is " + std::to_string(samplerIndex) + ", but the animation has " +
                            counted(samplers.size(), "samplers") + "; the channel is left out");
        return;
    }
    if (samplers[samplerIndex].is_null()) {
        return;  // told already
    }
    std::optional<Aim> aim = aimer_.aim(target, targetWhere);
    if (!aim) {
        return;
    }
    if (source.moved.contains(movedBy(aim->channel))) {
        aimer_.leaveOut("is moved by an earlier channel of the animation already", targetWhere);
        return;
    }
    aim->channel.sampler = samplerOf(source, samplerIndex, aim->use, animation);
    if (aim->channel.sampler < 0) {
        return;
    }
    if (aim->channel.part == Part::kDial) {
        checkRange(
            aim->channel, animation.samplers[std::size_t(aim->channel.sampler)],
            import_.file.at("accessors").at(samplers[samplerIndex]["output"].get<std::size_t>()));
    }
    source.moved.insert(movedBy(aim->channel));
    animation.channels.push_back(aim->channel);
}

// Says where keys hold what cannot be drawn; what is between them is kept in range as well.
void Reader::checkRange(const AnimationChannel& channel, const AnimationSampler& sampler,
                        const Place& place) {
    constexpr double kRounding = 1e-6;  // of single precision
    const Dial::Numbers numbers = aimer_.dialSources()[std::size_t(channel.mover)].numbers;
    std::size_t wrong = 0;
    std::pair<double, double> first;
    forEachKeyValue(sampler, [&](const glm::vec4& values) {
        for (int c = 0; c < channel.count; ++c) {
            const auto value = double(values[c]);
            const double drawn = nearestDrawn(numbers, channel.first + c, value);
            if (!(std::abs(drawn - value) <= kRounding * std::abs(value))) {
                first = wrong == 0 ? std::pair(value, drawn) : first;
                ++wrong;
            }
        }
    });
    if (wrong > 0) {
        report_.repaired(place, "gives " + counted(wrong, "keys") +
                                    " a value that cannot be drawn, such as " + shown(first.first) +
                                    "; the nearest that can is played, there " +
                                    shown(first.second));
    }
}

// Into Animation::samplers; -1 where it cannot be used, which is told once.
int Reader::samplerOf(Source& source, std::size_t index, const SamplerUse& use,
                      Animation& animation) {
    const auto [known, isNew] = source.samplers.try_emplace({index, use}, -1);
    if (isNew) {
        const Where samplers(source.where, "samplers");
        try {
            animation.samplers.push_back(samplers_.read(source.text["samplers"][index], use,
                                                        Where(samplers, index).place()));
            known->second = int(animation.samplers.size()) - 1;
        } catch (const Error& error) {
            report_.ignored(error.place(), reasonOf(error) + kLeftOut);
        }
    }
    return known->second;
}

// Takes, runs, jumps of one figure are not meant to be seen together.
void Reader::hintAtRivals() {
    std::map<Moved, std::size_t> first;
    for (std::size_t i = 0; i < scene_.animations.size(); ++i) {
        for (const AnimationChannel& channel : scene_.animations[i].channels) {
            const auto [known, isNew] = first.try_emplace(movedBy(channel), i);
            if (!isNew && known->second != i) {
                report_.hint(import_.file.at("animations").at(i),
                             "moves what animation " + std::to_string(known->second) +
                                 " moves; played together the earlier is seen, choose one with "
                                 "--animation");
                return;
            }
        }
    }
}

}  // namespace

std::vector<DialSource> readAnimations(const Import& import, const NodeList& list, Scene& scene,
                                       Report& report) {
    if (member(import.json, "animations").empty()) {
        return {};
    }
    return Reader(import, list, scene, report).readAll();
}

}  // namespace ribalta::gltf
