// The bits of every buffer of the scenes that come with the program, against those that buffer_hashes.txt holds. A change
// that is meant to keep the bits keeps that file; a change that moves bits writes it anew in the same commit, so that
// the difference shows which buffers moved:
//   SHADESCOPE_WRITE_HASHES=1 build/headless/tests/reference/reference_tests --gtest_filter='BufferHashes.*'
#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <map>
#include <sstream>

#include "pipeline/formats/built_in_scenes.h"
#include "pipeline/formats/scene_reader.h"
#include "pipeline/scene/settings_table.h"
#include "tests/support/hashes.h"
#include "tests/support/scenes.h"

namespace pipeline {
namespace {

constexpr const char* kFile = BUFFER_HASHES;

// A scene as it comes, or with settings that make a stage call a function that it does not call elsewhere.
struct Variant {
    std::string scene;
    std::vector<std::string> settings{};
    std::string name() const {
        std::string text = scene;
        for (const std::string& setting : settings) text += ' ' + setting;
        return text;
    }
};

std::vector<Variant> variants() {
    std::vector<Variant> all;
    for (const BuiltInScene& scene : builtInScenes()) all.push_back({scene.name});
    // Angles whose sine and cosine no library agrees on, the angles at a polygon's vertices, every form of the power.
    all.push_back({"pyramid", {"camera.theta=28.5"}});
    all.push_back({"pyramid", {"object.0.rz=28.5"}});
    for (const char* form : {"atan2", "acos"})
        all.push_back({"teapot", {"normal_weight=angle", std::string("numerics.corner_angle=") + form}});
    for (const char* form : {"pow", "squaring", "exp2", "schlick", "gaussian"})
        all.push_back({"teapot", {std::string("numerics.power=") + form}});
    return all;
}

// In a small picture and small shadow buffers. Nothing, and a failure, where the scene cannot be read.
std::optional<Scene> read(const Variant& variant) {
    for (const BuiltInScene& of : builtInScenes()) {
        if (of.name != variant.scene) continue;
        Result<Scene> found = readScene(of.file);
        for (const std::string& setting : variant.settings)
            if (found) found = withSetting(std::move(found).value(), setting);
        if (!found) {
            ADD_FAILURE() << variant.name() << ": " << format(found.errors());
            return std::nullopt;
        }
        Scene scene = std::move(found).value();
        scene.camera.pixelsPerUnit *= 120.0 / scene.settings.height;
        scene.settings.width = 160, scene.settings.height = 120;
        scene.settings.shadowSize = std::min(scene.settings.shadowSize, 256);
        return scene;
    }
    ADD_FAILURE() << variant.scene << " does not come with the program";
    return std::nullopt;
}

// By the buffer's name.
std::map<std::string, std::string> hashesOf(const Frame& frame) {
    std::map<std::string, std::string> hashes;
    for (const AnyBuffer& buffer : frame.buffers()) hashes[buffer.name.text()] = test::hashOf(buffer);
    return hashes;
}

constexpr std::array kPrecisions{Precision::Float, Precision::Double};
constexpr std::array<std::string_view, 2> kPrecisionNames{"float", "double"};

// Of a variant and a precision.
using Hashes = std::map<std::pair<std::string, std::size_t>, std::map<std::string, std::string>>;

// A line "[variant]", then one line a buffer: its name and its hashes in float and in double.
Hashes stored() {
    Hashes hashes;
    std::ifstream in(kFile);
    std::string variant;
    for (std::string line; std::getline(in, line);) {
        if (line.empty() || line[0] == '#') continue;
        if (line[0] == '[') {
            variant = line.substr(1, line.size() - 2);
            continue;
        }
        std::istringstream words(line);
        std::string buffer, hash;
        words >> buffer;
        for (std::size_t p = 0; words >> hash && p < kPrecisions.size(); ++p) hashes[{variant, p}][buffer] = hash;
    }
    return hashes;
}

void write(const Hashes& hashes) {
    std::ofstream out(kFile);
    out << "# Hashes of every buffer of the scenes that come with the program, at 160 x 120: in float, in double.\n"
           "# buffer_hashes_test.cpp says how to write this file anew.\n";
    for (const Variant& variant : variants()) {
        out << "\n[" << variant.name() << "]\n";
        for (const auto& [buffer, hash] : hashes.at({variant.name(), 0}))
            out << buffer << std::string(std::max<std::size_t>(1, 24 - std::min<std::size_t>(24, buffer.size())), ' ')
                << hash << ' ' << hashes.at({variant.name(), 1}).at(buffer) << '\n';
    }
    ASSERT_TRUE(out.flush()) << kFile << " cannot be written";
}

// The names of the buffers that are not the same in both, or not in both.
std::string changed(const std::map<std::string, std::string>& a, const std::map<std::string, std::string>& b) {
    std::map<std::string, std::string> all = a;
    all.insert(b.begin(), b.end());
    std::string names;
    for (const auto& [name, hash] : all) {
        if (const auto i = a.find(name), k = b.find(name); i != a.end() && k != b.end() && i->second == k->second)
            continue;
        names += (names.empty() ? "" : ", ") + name;
    }
    return names;
}

// With everything left out that can be on all threads, and with everything computed on one.
TEST(BufferHashes, AreThoseStoredWithLeavingOutAndWithout) {
    Hashes hashes;
    for (const Variant& variant : variants()) {
        std::optional<Scene> scene = read(variant);
        if (!scene) continue;
        for (std::size_t p = 0; p < kPrecisions.size(); ++p) {
            scene->settings.precision = kPrecisions[p];
            scene->settings.leaveOut = true, scene->settings.rules = RuleSet().set();
            const auto leavingOut = hashesOf(*test::frameOf(*scene));
            scene->settings.leaveOut = false;
            EXPECT_EQ(changed(leavingOut, hashesOf(*test::frameOf(*scene, test::everyBuffer(), 1))), "")
                << variant.name() << " in " << kPrecisionNames[p]
                << ": buffers that leaving out or the number of threads changes";
            hashes[{variant.name(), p}] = leavingOut;
        }
    }
    if (std::getenv("SHADESCOPE_WRITE_HASHES")) {
        write(hashes);
        return;
    }
    Hashes before = stored();
    for (const auto& [of, now] : hashes)
        EXPECT_EQ(changed(before[of], now), "") << of.first << " in " << kPrecisionNames[of.second]
                                                << ": buffers whose bits are not those stored in " << kFile;
    EXPECT_EQ(before.size(), hashes.size()) << kFile << " holds scenes that do not come with the program";
}

}  // namespace
}  // namespace pipeline
