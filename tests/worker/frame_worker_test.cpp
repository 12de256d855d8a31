// The worker that computes frames, without Qt, so that the thread sanitizer sees every lock.
#include "app/frames/frame_worker.h"

#include <gtest/gtest.h>

#include <chrono>
#include <future>
#include <map>

#include "pipeline/formats/scene_reader.h"
#include "tests/support/little_memory.h"

namespace app {
namespace {

using namespace std::chrono_literals;
using Running = FrameWorker::Running;

std::shared_ptr<const pipeline::Scene> pyramid(int width, double exponent = 8) {
    auto scene = pipeline::readScene(pipeline::resourceFolder() / "scenes" / "pyramid.scene");
    if (!scene) throw std::runtime_error(format(scene.errors()));
    auto copy = std::make_shared<pipeline::Scene>(std::move(scene).value());
    copy->settings.width = width;
    copy->settings.height = width * 3 / 4;
    copy->objects[0].material.exponent = exponent;
    return copy;
}

// One thread a frame: the library that splits the work is not built for the sanitizer, and what is
// tested here is the worker.
pipeline::FrameRequest color() {
    return {.wanted = pipeline::setOf({pipeline::BufferId::Color}), .threads = 1, .stop = {}};
}

// What a worker has delivered, as its thread has called.
class Deliveries {
public:
    FrameWorker::Deliver frames() {
        return [this](pipeline::FramePtr frame, long ticket) {
            const std::lock_guard lock(m_mutex);
            m_frames[ticket] = std::move(frame);
            m_changed.notify_all();
        };
    }
    FrameWorker::DeliverCheck checks() {
        return [this](pipeline::FramePtr frame, const FrameCheck& check) {
            const std::lock_guard lock(m_mutex);
            m_checks.emplace_back(std::move(frame), check);
            m_changed.notify_all();
        };
    }
    pipeline::FramePtr waitFor(long ticket) {
        std::unique_lock lock(m_mutex);
        m_changed.wait_for(lock, 60s, [&] { return m_frames.contains(ticket); });
        return m_frames.contains(ticket) ? m_frames[ticket] : nullptr;
    }
    bool waitForCheckOf(const pipeline::FramePtr& frame) {
        std::unique_lock lock(m_mutex);
        return m_changed.wait_for(lock, 60s, [&] { return !m_checks.empty() && m_checks.back().first == frame; });
    }
    bool has(long ticket) {
        const std::lock_guard lock(m_mutex);
        return m_frames.contains(ticket);
    }
    std::size_t frameCount() {
        const std::lock_guard lock(m_mutex);
        return m_frames.size();
    }
    FrameCheck lastCheck() {
        const std::lock_guard lock(m_mutex);
        return m_checks.back().second;
    }

private:
    std::mutex m_mutex;
    std::condition_variable m_changed;
    std::map<long, pipeline::FramePtr> m_frames;
    std::vector<std::pair<pipeline::FramePtr, FrameCheck>> m_checks;
};

TEST(FrameWorker, DeliversTheFrameOfItsRequest) {
    Deliveries got;
    FrameWorker worker(got.frames(), got.checks());
    const auto scene = pyramid(64);
    const long ticket = worker.request(scene, color(), Running::Stop);
    const auto frame = got.waitFor(ticket);
    ASSERT_TRUE(frame);
    EXPECT_EQ(frame->sharedScene(), scene);
}

TEST(FrameWorker, NewestOfManyRequestsComesAndOldOnesAreDropped) {
    Deliveries got;
    FrameWorker worker(got.frames(), got.checks());
    const auto scene = pyramid(256);
    long last = 0;
    for (int i = 1; i <= 200; ++i) {
        auto changed = std::make_shared<pipeline::Scene>(*scene);
        changed->objects[0].material.exponent = i;
        last = worker.request(std::move(changed), color(), Running::Finish);
    }
    const auto frame = got.waitFor(last);
    ASSERT_TRUE(frame);
    EXPECT_EQ(frame->scene().objects[0].material.exponent, 200);
    // Copying a scene is faster than shading it: some requests had to wait and were replaced.
    EXPECT_LT(got.frameCount(), 200u);
}

TEST(FrameWorker, StoppedFrameIsFollowedByTheOneThatStoppedIt) {
    Deliveries got;
    FrameWorker worker(got.frames(), got.checks());
    for (int i = 1; i <= 10; ++i) {
        worker.request(pyramid(800, i), color(), Running::Stop);
        std::this_thread::sleep_for(1ms);
        const long ticket = worker.request(pyramid(64, i), color(), Running::Stop);
        const auto frame = got.waitFor(ticket);
        ASSERT_TRUE(frame);
        EXPECT_EQ(frame->scene().settings.width, 64);
    }
}

TEST(FrameWorker, ACancelledFrameDoesNotComeAndTheNextOneDoes) {
    Deliveries got;
    FrameWorker worker(got.frames(), got.checks());
    int came = 0;
    for (int i = 1; i <= 10; ++i) {
        const long large = worker.request(pyramid(1600, i), color(), Running::Stop);
        if (i % 2) std::this_thread::sleep_for(1ms);
        worker.cancel();
        ASSERT_TRUE(got.waitFor(worker.request(pyramid(64, i), color(), Running::Finish)));
        came += got.has(large);
    }
    EXPECT_LT(came, 10) << "one may be done before it is cancelled, on a busy machine";
}

// Of 4000 × 3000 pixels the positions and the normals are 144 MB each: neither fits into 100 MB more.
TEST(FrameWorker, AFrameWithoutMemoryIsToldAndTheNextOneComes) {
    if (!test::LittleMemory::kWorks) GTEST_SKIP() << "a sanitizer reserves more addresses than there are";
    Deliveries got;
    std::promise<long> failed;
    FrameWorker worker(got.frames(), nullptr, [&](long ticket) { failed.set_value(ticket); });
    ASSERT_TRUE(got.waitFor(worker.request(pyramid(64), color(), Running::Stop)));
    pipeline::FrameRequest large = color();
    large.wanted |= pipeline::setOf({pipeline::BufferId::Position, pipeline::BufferId::Normal});
    long ticket = 0;
    {
        const test::LittleMemory little(100'000'000);
        ticket = worker.request(pyramid(4000), large, Running::Stop);
        auto told = failed.get_future();
        ASSERT_EQ(told.wait_for(60s), std::future_status::ready);
        EXPECT_EQ(told.get(), ticket);
    }
    EXPECT_FALSE(got.has(ticket));
    ASSERT_TRUE(got.waitFor(worker.request(pyramid(64, 4), color(), Running::Stop)));
    ASSERT_TRUE(got.waitFor(worker.request(pyramid(4000), large, Running::Stop))) << "there is memory again";
}

TEST(FrameWorker, ReusesWhatTheChangeDoesNotTouch) {
    Deliveries got;
    FrameWorker worker(got.frames(), got.checks());
    // One scene, so that both frames share the mesh, as a change in the window does.
    auto changed = std::make_shared<pipeline::Scene>(*pyramid(64));
    const auto before = std::make_shared<const pipeline::Scene>(*changed);
    changed->objects[0].material.exponent = 4;
    ASSERT_TRUE(got.waitFor(worker.request(before, color(), Running::Stop)));
    const auto frame = got.waitFor(worker.request(changed, color(), Running::Stop));
    ASSERT_TRUE(frame);
    EXPECT_EQ(frame->plan()[index(pipeline::StageId::ZBuffer)].action, pipeline::Action::Reuse);
    EXPECT_EQ(frame->plan()[index(pipeline::StageId::Shading)].action, pipeline::Action::Run);
}

TEST(FrameWorker, ChecksTheFrameWhenNothingElseIsToDo) {
    Deliveries got;
    FrameWorker worker(got.frames(), got.checks());
    const auto frame = got.waitFor(worker.request(pyramid(64), color(), Running::Stop));
    ASSERT_TRUE(frame);
    ASSERT_TRUE(got.waitForCheckOf(frame));
    const FrameCheck check = got.lastCheck();
    EXPECT_EQ(check.nan, 0u);
    EXPECT_TRUE(check.errors[index(pipeline::StageId::Transform)].has_value());
}

// Nothing comes after the end: what `got` holds is what it holds a while later.
TEST(FrameWorker, EndsWhileAFrameIsComputed) {
    for (int i = 0; i < 10; ++i) {
        Deliveries got;
        {
            FrameWorker worker(got.frames(), got.checks());
            worker.request(pyramid(800), color(), Running::Finish);
            worker.request(pyramid(800), color(), Running::Finish);
            std::this_thread::sleep_for(std::chrono::milliseconds(i));
        }
        const auto atTheEnd = got.frameCount();
        std::this_thread::sleep_for(std::chrono::milliseconds(20));
        EXPECT_EQ(got.frameCount(), atTheEnd);
    }
}

}  // namespace
}  // namespace app
