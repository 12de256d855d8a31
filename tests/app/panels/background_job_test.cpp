#include "app/jobs/background_job.h"

#include <gtest/gtest.h>

#include <QCloseEvent>
#include <QSignalSpy>
#include <QTest>
#include <QThreadPool>
#include <QWidget>
#include <atomic>

#include "app/jobs/free_in_background.h"
#include "app/jobs/memory_notice.h"
#include "app/jobs/work_list.h"
#include "app/look/window_look.h"

namespace app {
namespace {

using Control = BackgroundJob::Control;

// Waits on the job's thread until it is told to go on or to stop.
struct Gate {
    std::atomic<bool> open{false};
    bool wait(const Control& control) const {
        while (!open && !control.stop.stop_requested()) std::this_thread::yield();
        return open;
    }
};

}  // namespace

TEST(BackgroundJob, GivesItsResultInThisThread) {
    BackgroundJob job;
    int result = 0;
    const auto here = std::this_thread::get_id();
    job.ask([here](const Control&) { return std::this_thread::get_id() == here ? 1 : 2; },
            [&](int given) { result = std::this_thread::get_id() == here ? given : 3; });
    EXPECT_TRUE(job.busy());
    ASSERT_TRUE(QTest::qWaitFor([&] { return result != 0; }, 10000));
    EXPECT_EQ(result, 2) << "computed on another thread, given in this one";
    EXPECT_FALSE(job.busy());
}

TEST(BackgroundJob, WithoutMemoryItEndsAndSaysSoAndTheNextOneIsDone) {
    BackgroundJob job;
    const QSignalSpy notices(&MemoryNotice::instance(), &MemoryNotice::gaveUp);
    std::vector<int> given;
    for (const int number : {1, 2}) {
        job.ask(
            [number](const Control&) {
                if (number == 1) throw std::bad_alloc();
                return number;
            },
            [&](int result) { given.push_back(result); });
        ASSERT_TRUE(QTest::qWaitFor([&] { return !job.busy(); }, 10000));
    }
    EXPECT_EQ(notices.size(), 1);
    EXPECT_EQ(given, std::vector{2});
}

// A click whose answer needs more memory than there is: the loop goes on, with the next event as well.
TEST(Application, WithoutMemoryAnEventIsGivenUpAndTheNextOneIsDone) {
    const QSignalSpy notices(&MemoryNotice::instance(), &MemoryNotice::gaveUp);
    QObject receiver;
    std::vector<int> done;
    for (const int number : {1, 2})
        QMetaObject::invokeMethod(
            &receiver,
            [&done, number] {
                if (number == 1) throw std::bad_alloc();
                done.push_back(number);
            },
            Qt::QueuedConnection);
    ASSERT_TRUE(QTest::qWaitFor([&] { return !done.empty(); }, 10000));
    EXPECT_EQ(notices.size(), 1);
    EXPECT_EQ(done, std::vector{2});
}

// A window that is closed saves first. Where that runs out of memory, it stays open with what it holds.
TEST(Application, WithoutMemoryAWindowStaysOpen) {
    struct Window : QWidget {
        void closeEvent(QCloseEvent*) override { throw std::bad_alloc(); }
    } window;
    window.show();
    EXPECT_FALSE(window.close());
    EXPECT_TRUE(window.isVisible());
}

TEST(BackgroundJob, WithoutMemoryForItsResultItEndsAllTheSame) {
    BackgroundJob job;
    const QSignalSpy changes(&job, &BackgroundJob::busyChanged);
    job.ask([](const Control&) { return 1; }, [](int) { throw std::bad_alloc(); });
    EXPECT_TRUE(QTest::qWaitFor([&] { return changes.size() == 2; }, 10000)) << "busy, and idle again";
    EXPECT_FALSE(job.busy());
}

TEST(BackgroundJob, ANewerOneStopsWhatRunsAndReplacesWhatWaits) {
    BackgroundJob job;
    Gate gate;
    std::vector<int> given;
    const auto ask = [&](int number) {
        job.ask(
            [&gate, number](const Control& control) {
                if (number == 1) gate.wait(control);
                return number;
            },
            [&](int result) { given.push_back(result); });
    };
    for (const int number : {1, 2, 3}) ask(number);
    ASSERT_TRUE(QTest::qWaitFor([&] { return !job.busy(); }, 10000));
    ASSERT_FALSE(given.empty());
    EXPECT_EQ(given.back(), 3);
    EXPECT_EQ(std::ranges::count(given, 1), 0);
}

TEST(BackgroundJob, WhatRunsMayFinishWhereThatIsAsked) {
    BackgroundJob job;
    Gate gate;
    std::atomic<bool> begun{false};
    std::vector<int> given;
    job.ask(
        [&](const Control& control) {
            begun = true;
            gate.wait(control);
            return 1;
        },
        [&](int result) { given.push_back(result); });
    ASSERT_TRUE(QTest::qWaitFor([&] { return begun.load(); }, 10000));
    job.ask([](const Control&) { return 2; }, [&](int result) { given.push_back(result); },
            BackgroundJob::Running::Finish);
    gate.open = true;
    ASSERT_TRUE(QTest::qWaitFor([&] { return !job.busy(); }, 10000));
    EXPECT_EQ(given, (std::vector{1, 2}));
}

TEST(BackgroundJob, WorkSeesTheLookThatTheWindowHadWhenItWasAsked) {
    Theme& theme = Theme::current();
    NumberStyle& numbers = NumberStyle::current();
    const WindowLook before;
    BackgroundJob job;
    Gate gate;
    std::optional<WindowLook> seen;
    job.ask(
        [&](const Control& control) {
            gate.wait(control);
            return WindowLook();
        },
        [&](const WindowLook& look) { seen = look; });
    theme.set(ThemeId::Dark);
    theme.setScale(2);
    numbers.set({.form = NumberFormat::Form::Hexadecimal, .power = {}});
    EXPECT_NE(WindowLook(), before);
    gate.open = true;
    EXPECT_TRUE(QTest::qWaitFor([&] { return seen.has_value(); }, 10000));
    EXPECT_EQ(seen, before);
    theme.setScale(1);
    theme.set(before.theme.id);
    numbers.set(before.numbers);
}

TEST(BackgroundJob, ForgottenWorkGivesNothing) {
    BackgroundJob job;
    bool isGiven = false;
    Gate gate;
    std::atomic<bool> over{false};
    job.ask(
        [&](const Control& control) {
            gate.wait(control);
            over = true;
            return 0;
        },
        [&](int) { isGiven = true; });
    job.forget();
    EXPECT_FALSE(job.busy());
    QTest::qWait(50);
    EXPECT_FALSE(isGiven);
    // What goes away with work under way asks it to stop, and waits.
    {
        BackgroundJob other;
        other.ask([&](const Control& control) { return gate.wait(control); }, [&](bool) { isGiven = true; });
    }
    EXPECT_FALSE(isGiven);
}

TEST(BackgroundJob, SaysHowFarItIs) {
    BackgroundJob job;
    QSignalSpy progress(&job, &BackgroundJob::progressed);
    QSignalSpy busy(&job, &BackgroundJob::busyChanged);
    bool done = false;
    job.ask(
        [](const Control& control) {
            for (const double share : {0.25, 0.5, 0.5, 1.0}) control.progress(share);
            return 0;
        },
        [&](int) { done = true; });
    ASSERT_TRUE(QTest::qWaitFor([&] { return done; }, 10000));
    EXPECT_EQ(progress.size(), 3) << "the same percentage is no news";
    EXPECT_EQ(busy.size(), 2);
}

TEST(BackgroundJob, WaitedForItComesWithinTheCall) {
    BackgroundJob job;
    int result = 0;
    job.ask([](const Control&) { return 7; }, [&](int given) { result = given; });
    EXPECT_TRUE(job.waitFor(std::chrono::minutes(1)));
    EXPECT_EQ(result, 7);
    EXPECT_FALSE(job.busy());
    EXPECT_TRUE(job.waitFor(std::chrono::minutes(1))) << "there is nothing to wait for";
}

TEST(BackgroundJob, WaitedForInVainItComesLater) {
    BackgroundJob job;
    Gate gate;
    int result = 0;
    job.ask([&](const Control& control) { return gate.wait(control) ? 7 : 0; }, [&](int given) { result = given; });
    EXPECT_FALSE(job.waitFor(std::chrono::milliseconds(1)));
    EXPECT_EQ(result, 0);
    gate.open = true;
    EXPECT_TRUE(QTest::qWaitFor([&] { return result == 7; }, 10000));
}

// The window and a worker hold it; whichever lets go last, the window's thread does not free it.
TEST(FreedAside, IsFreedOnAnotherThreadThanTheWindows) {
    struct Large {
        std::thread::id* freedOn;
        ~Large() { *freedOn = std::this_thread::get_id(); }
    };
    std::thread::id freedOn{};
    std::shared_ptr<const Large> own(new Large{&freedOn});
    const Large* at = own.get();
    auto shown = freedInBackground(std::move(own));
    EXPECT_EQ(shown.get(), at) << "it is the same thing";
    auto other = shown;
    shown.reset();
    EXPECT_EQ(freedOn, std::thread::id()) << "it is still held";
    other.reset();
    QThreadPool::globalInstance()->waitForDone();
    EXPECT_NE(freedOn, std::thread::id());
    EXPECT_NE(freedOn, std::this_thread::get_id());
    EXPECT_FALSE(freedInBackground(std::shared_ptr<const Large>()));
}

TEST(WorkList, TellsWhatTakesLongAndStopsItUntilItIsToGoOn) {
    WorkList list;
    int cancelled = 0, resumed = 0;
    {
        QObject frame, view;
        list.add(
            &frame, "the frame",
            [&] {
                ++cancelled;
                list.setBusy(&frame, false);
            },
            [&] { ++resumed; });
        list.add(
            &view, "the view", [] {}, [] {});
        list.setBusy(&frame, true);
        EXPECT_TRUE(list.running().isEmpty()) << "it may be done in a moment";
        ASSERT_TRUE(QTest::qWaitFor([&] { return list.running() == QStringList("the frame"); }, 5000));
        list.cancel();
        EXPECT_EQ(cancelled, 1);
        EXPECT_TRUE(list.running().isEmpty());
        EXPECT_EQ(list.stopped(), QStringList("the frame")) << "the view was idle";
        list.resume();
        EXPECT_EQ(resumed, 1);
        EXPECT_TRUE(list.stopped().isEmpty());
        list.setBusy(&frame, true);
        list.cancel();
        list.setBusy(&frame, true);
        EXPECT_FALSE(list.isStopped(&frame)) << "newer work is not";
        list.cancel();
        EXPECT_TRUE(list.isStopped(&frame));
    }
    EXPECT_TRUE(list.stopped().isEmpty()) << "forgotten with whose it was";
}

}  // namespace app
