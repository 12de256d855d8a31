// The program's own wrong frames, handed in as somebody else's through conventions: which known error is named.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>
#include <string>

#include "pipeline/compare/known_errors.h"
#include "pipeline/compare/verdict.h"
#include "pipeline/defects/defect_table.h"
#include "pipeline/defects/defect_ways.h"
#include "pipeline/formats/scene_reader.h"
#include "pipeline/run/runner.h"
#include "pipeline/scene/settings_table.h"
#include "pipeline/scene/view.h"
#include "tests/support/sweep.h"

using namespace pipeline;

namespace {

struct Convention {
    const char* name;
    bool bottomUp, bgr, window, bytes;  // color in bytes either way; the depth as window depth; bytes: depth in 16 bits
};
constexpr Convention kConventions[]{{"own", false, false, false, false},
                                    {"rows", true, false, false, false},
                                    {"bgr", false, true, true, false},
                                    {"rows bgr 16 bit", true, true, true, true}};

Scene checkMe() {
    auto scene = readScene(SHADESCOPE_STARTER "/check_me.toml");
    EXPECT_TRUE(scene);
    Scene out = std::move(scene).value();
    out.settings.width = 160, out.settings.height = 100;  // nothing is symmetrical at this size either
    out.camera.pixelsPerUnit /= 2;
    return out;
}

foreign::HandedFile file(const Frame& frame, const BufferName& name, const Convention& by) {
    const AnyBuffer buffer = *frame.buffer(name);
    foreign::HandedFile out;
    out.name.buffer = name, out.path = name.text() + ".npy";
    out.numbers.shape = buffer.shape, out.numbers.name = name.text();
    const std::size_t rows = buffer.rows(), columns = buffer.columns();
    const auto channels = std::size_t(buffer.channels());
    const View view = frame.scene().camera.near > 0 ? makeView(frame.scene()) : View();
    for (std::size_t y = 0; y < rows; ++y)
        for (std::size_t x = 0; x < columns; ++x)
            for (std::size_t c = 0; c < channels; ++c) {
                const bool swaps = by.bgr && name.id == BufferId::Color;
                double v = buffer.value(x, by.bottomUp ? rows - 1 - y : y, int(swaps ? 2 - c : c));
                if (name.id == BufferId::ZView && by.window)  // as glDepthRange(0, 1) has it
                    v = std::isfinite(v) ? view.far * (v - view.near) / (v * (view.far - view.near)) : 1;
                if (name.id == BufferId::ZView && by.bytes) v = std::round(65535 * v);
                out.numbers.values.push_back(v);
            }
    out.numbers.kind = name.id == BufferId::Color               ? NumberKind::Levels8
                       : name.id == BufferId::ZView && by.bytes ? NumberKind::Levels16
                                                                : NumberKind::Real;
    countStrange(out.numbers);
    return out;
}

foreign::HandedIn handedIn(const Scene& planted, const std::vector<BufferId>& handed, const Convention& by) {
    FrameRequest request;
    for (const BufferId id : handed) request.wanted.set(index(id));
    const FramePtr frame = runFrame(std::make_shared<const Scene>(planted), request, nullptr);
    foreign::HandedIn in;
    for (const BufferId id : handed) in.files.push_back(file(*frame, {id}, by));
    return in;
}

const std::vector<BufferId> kPicture{BufferId::ZView, BufferId::Color};

struct Outcome {
    std::size_t agreeing = 0, named = 0, amongCandidates = 0, none = 0, wrong = 0;
    std::string wrongly;
};

Outcome outcomeOf(const std::vector<BufferId>& handed) {
    const Scene scene = checkMe();
    const auto reference = std::make_shared<const foreign::Reference>(*foreign::makeReference(scene, {}, {}));
    foreign::CompareOptions options;
    Outcome out;
    const std::size_t defects = defectTable().size();
    const std::vector<std::size_t> samples = test::sweep(defects * std::size(kConventions));
    // Each sample tries all known errors, which takes seconds: a short run takes every fourth.
    for (std::size_t sample = 0; sample < samples.size(); sample += test::longRun() ? 1 : 4) {
        const std::size_t i = samples[sample];
        const DefectRow& row = defectTable()[i % defects];
        const Convention& by = kConventions[i / defects];
        const auto report =
            compareRenderer(scene, reference, handedIn(plant(scene, row.id), handed, by), "mine", options);
        EXPECT_TRUE(report) << row.idText();
        if (report->agrees()) {
            ++out.agreeing;
            continue;
        }
        if (!report->suspects) continue;  // files that hold nothing, as an empty picture, accuse nobody
        const auto& candidates = report->suspects->candidates;
        const bool among =
            std::ranges::any_of(candidates, [&](const foreign::Candidate& c) { return c.error.id == row.idText(); });
        out.named += among && candidates.size() == 1;
        out.amongCandidates += among && candidates.size() > 1;
        out.none += candidates.empty();
        if (!among && !candidates.empty()) {
            ++out.wrong;
            out.wrongly += std::string(row.idText()) + " (" + by.name + ") as " + candidates[0].error.id + "; ";
        }
        if (test::longRun() || !among)
            std::printf("%-18s %-16s %s%s\n", std::string(row.idText()).c_str(), by.name,
                        candidates.empty() ? "none"
                        : among            ? candidates.size() == 1 ? "named" : "among"
                                           : "WRONG ",
                        candidates.empty() ? "" : (" " + candidates[0].error.id).c_str());
    }
    std::printf("agreeing %zu, named %zu, among candidates %zu, none %zu, wrong %zu\n", out.agreeing, out.named,
                out.amongCandidates, out.none, out.wrong);
    return out;
}

// Two errors at once, in stages and in ways that do not hide each other: both are named, that of the earlier stage first.
TEST(CompareConfusion, twoAtOnceAreBothNamed) {
    struct Two {
        Defect first;
        int way;
        Defect second;
        std::vector<std::string> ids;
    };
    const std::vector<Two> all{{Defect::Aspect, 0, Defect::NoMax, {"aspect", "no-max"}},
                               {Defect::NoAmbient, 0, Defect::NearDrop, {"near-drop", "no-ambient"}}};
    const Scene scene = checkMe();
    const auto reference = std::make_shared<const foreign::Reference>(*foreign::makeReference(scene, {}, {}));
    for (const Two& two : all) {
        const Scene planted = plantToo(plant(scene, two.first, two.way), two.second);
        // Every known error is tried, and each is told of once.
        foreign::CompareOptions options;
        std::size_t told = 0;
        options.progress = [&](std::string_view, std::size_t done, std::size_t count) {
            EXPECT_EQ(done, told++);
            EXPECT_EQ(count, foreign::knownErrors(scene).size());
        };
        const auto report =
            compareRenderer(scene, reference, handedIn(planted, kPicture, kConventions[0]), "mine", options);
        ASSERT_TRUE(report && report->suspects) << two.ids[0];
        EXPECT_EQ(told, foreign::knownErrors(scene).size());
        EXPECT_EQ(report->suspects->tried, told);
        std::vector<std::string> ids;
        for (const foreign::Candidate& one : report->suspects->candidates) ids.push_back(one.error.id);
        EXPECT_EQ(ids, two.ids) << headline(*report);
        EXPECT_TRUE(report->suspects->areTogether) << two.ids[0];
        EXPECT_EQ(report->possiblyWrong.size(), 1u) << two.ids[0];
        EXPECT_EQ(report->firstWrong, report->suspects->candidates.front().error.stage) << two.ids[0];
    }
}

// Ways of a defect that have names of their own, by picture and depth; in a short run every other one.
TEST(CompareConfusion, waysWithNamesOfTheirOwnAreNamed) {
    struct Named {
        Defect defect;
        int way;
        std::string id;
    };
    const std::vector<Named> all{{Defect::NormalShort, kExchanged, "weights-swapped"},
                                 {Defect::ZAffine, kExchangedDepths, "weights-swapped"},
                                 {Defect::ZAffine, kDividedTwice, "divided-twice"},
                                 {Defect::ZAffine, kNdcDividedTwice, "divided-twice"},
                                 {Defect::Exponent, kPowerOfNegative, "power-of-negative"},
                                 {Defect::BlocksOfFour, 0, "blocks-of-four"},
                                 {Defect::BlocksOfFour, kFourByFour, "blocks-of-four"}};
    for (std::size_t i = 0; i < all.size(); i += test::longRun() ? 1 : 2) {
        const Named& one = all[i];
        Scene scene = checkMe();
        if (one.id == "divided-twice") scene.settings.depthFormat = DepthFormat::Float;
        const auto reference = std::make_shared<const foreign::Reference>(*foreign::makeReference(scene, {}, {}));
        auto in = handedIn(plant(scene, one.defect, one.way), kPicture, kConventions[2]);
        const auto report = compareRenderer(scene, reference, std::move(in), "mine", {});
        ASSERT_TRUE(report && report->suspects) << one.id;
        ASSERT_EQ(report->suspects->candidates.size(), 1u) << one.id << one.way << ": " << headline(*report);
        EXPECT_EQ(report->suspects->candidates[0].error.id, one.id) << headline(*report);
        EXPECT_EQ(report->firstWrong, report->suspects->candidates[0].error.stage) << one.id << one.way;
    }
}

// A trial with colour alone named 100 of 132, 32 among two, none wrongly; bmp and noise aside this asks as much.
TEST(CompareConfusion, ofColourAloneNothingIsNamedWrongly) {
    const Outcome out = outcomeOf({BufferId::Color});
    EXPECT_EQ(out.wrong, 0u) << out.wrongly;
    EXPECT_GE(out.named + out.amongCandidates, 9 * (out.named + out.amongCandidates + out.none) / 10);
}

TEST(CompareConfusion, withDepthAndNormalsMoreIsNamed) {
    const Outcome out = outcomeOf({BufferId::ZView, BufferId::Normal, BufferId::Color});
    EXPECT_EQ(out.wrong, 0u) << out.wrongly;
    // Some pairs leave the same numbers in all of these buffers: rows from the foot, exponents, what shadows read.
    EXPECT_GE(out.named, 7 * (out.named + out.amongCandidates + out.none) / 10);
    EXPECT_GE(out.named + out.amongCandidates, 95 * (out.named + out.amongCandidates + out.none) / 100);
}

// Errors before shading, in all ways of planting them, without a name: what is seen in place of the right polygons tells the
// stage, or leaves three of them open. Nothing here has to do with the renderers in tests/student.
TEST(CompareConfusion, depthsTellTheFirstStageOrLeaveItOpen) {
    const Scene scene = checkMe();
    const auto reference = std::make_shared<const foreign::Reference>(*foreign::makeReference(scene, {}, {}));
    foreign::CompareOptions options;
    options.known = false;
    std::size_t right = 0, open = 0, wrong = 0;
    std::string wrongly;
    for (const DefectRow& row : defectTable())
        for (int way = 0; way < row.wayCount(); ++way) {
            if (row.stage != StageId::Transform && row.stage != StageId::Cull && row.stage != StageId::ZBuffer)
                continue;
            const Scene planted = plantToo(scene, row.id, way);
            if (planted == scene || !checkScene(planted).empty()) continue;
            const auto report =
                compareRenderer(scene, reference, handedIn(planted, kPicture, kConventions[0]), "mine", options);
            ASSERT_TRUE(report) << row.idText();
            const bool differs = std::ranges::any_of(report->findings, [](const foreign::Finding& f) {
                return f.name.buffer.id == BufferId::ZView && !f.agrees;
            });
            if (!differs) continue;
            const auto& stages = report->possiblyWrong;
            const bool among = std::ranges::find(stages, row.stage) != stages.end();
            ++(!among ? wrong : stages.size() == 1 ? right : open);
            if (!among) wrongly += std::string(row.idText()) + " " + std::to_string(way) + "; ";
        }
    std::printf("right %zu, open %zu, wrong %zu: %s\n", right, open, wrong, wrongly.c_str());
    EXPECT_EQ(wrong, 0u) << wrongly;
    EXPECT_GE(right, open / 2);
}

}  // namespace
