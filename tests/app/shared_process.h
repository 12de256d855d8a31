#pragma once
#include <gtest/gtest.h>

#include <QClipboard>
#include <QSettings>
#include <QTemporaryDir>
#include <optional>

#include "app/jobs/application.h"
#include "app/look/number_format.h"
#include "app/look/theme.h"

namespace test {

// What the tests of a process share is before each of them as at the process's start.
class AsAtTheStart : public testing::EmptyTestEventListener {
public:
    AsAtTheStart() {
        QObject::connect(&app::Theme::current(), &app::Theme::changed, &m_receiver, [this] { m_themeIsOther = true; });
        QObject::connect(&app::NumberStyle::current(), &app::NumberStyle::changed, &m_receiver,
                         [this] { m_numbersAreOther = true; });
        restore();
    }
    void OnTestStart(const testing::TestInfo&) override { restore(); }
    void OnTestEnd(const testing::TestInfo&) override {
        QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
    }

private:
    void restore() {
        // The user's own settings, session, cues and results of lessons stay as they are.
        QCoreApplication::setOrganizationName("shadescope-test");
        QCoreApplication::setApplicationName("shadescope-test");
        m_folder.emplace();
        QSettings::setPath(QSettings::IniFormat, QSettings::UserScope, m_folder->path());
        qputenv("XDG_DATA_HOME", m_folder->path().toUtf8());
        QSettings().clear();
        QApplication::clipboard()->clear();
        if (m_themeIsOther) {
            auto& theme = app::Theme::current();
            for (const auto& [id, scale] :
                 {std::pair(app::ThemeId::Dark, 1.0), std::pair(app::ThemeId::Projector, 1.25),
                  std::pair(app::ThemeId::Light, 1.0)}) {
                theme.set(id);
                theme.setScale(scale);
            }
        }
        if (m_numbersAreOther) app::NumberStyle::current().set({});
        m_themeIsOther = m_numbersAreOther = false;
    }

    std::optional<QTemporaryDir> m_folder;
    QObject m_receiver;
    bool m_themeIsOther = true, m_numbersAreOther = true;
};

// Runs the tests of a program with widgets. Those that need no OpenGL draw the same without a display.
inline int runAppTests(int argc, char** argv) {
    testing::InitGoogleTest(&argc, argv);
    if (qEnvironmentVariableIsEmpty("DISPLAY")) qputenv("QT_QPA_PLATFORM", "offscreen");
    QSettings::setDefaultFormat(QSettings::IniFormat);
    app::Application application(argc, argv);
    QApplication::setStyle("Fusion");
    auto& listeners = testing::UnitTest::GetInstance()->listeners();
    auto* atTheStart = new AsAtTheStart;
    listeners.Append(atTheStart);
    const int status = RUN_ALL_TESTS();
    delete listeners.Release(atTheStart);  // before the application
    return status;
}

}  // namespace test
