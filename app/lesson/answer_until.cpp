#include <QGridLayout>
#include <QLabel>
#include <QPainter>
#include <algorithm>
#include <cmath>

#include "app/document/hand.h"
#include "app/lesson/answer_body.h"
#include "app/look/text.h"
#include "app/settings/setting_row.h"
#include "app/widgets/follow_theme.h"

namespace app {

namespace {

// The left side of the condition as a bar, with a mark where it has to come to.
class GaugeBar : public QWidget {
public:
    explicit GaugeBar(QWidget* parent) : QWidget(parent) {
        followTheme(this, [this] { setFixedHeight(Theme::current().px(22)); });
    }
    void set(const std::optional<lessons::Gauge>& gauge) {
        m_gauge = gauge;
        setVisible(gauge && std::isfinite(gauge->value) && std::isfinite(gauge->needed));
        update();
    }

protected:
    void paintEvent(QPaintEvent*) override {
        if (!m_gauge) return;
        const ThemeColors& c = Theme::current().colors();
        // The mark stays where it is while the value moves, unless that leaves the bar.
        const double low = std::min({0.0, m_gauge->needed * 2, m_gauge->value});
        const double high = std::max({0.0, m_gauge->needed * 2, m_gauge->value});
        const auto at = [&](double value) { return high > low ? width() * (value - low) / (high - low) : 0; };
        QPainter painter(this);
        const double top = height() * 0.25, tall = height() * 0.5;
        painter.fillRect(QRectF(0, top, width(), tall), c.hover);
        const double from = std::min(at(0), at(m_gauge->value)), to = std::max(at(0), at(m_gauge->value));
        painter.fillRect(QRectF(from, top, to - from, tall), m_gauge->holds ? c.run : c.fill);
        painter.fillRect(QRectF(at(m_gauge->needed) - 1.25, 0, 2.5, height()), c.text);
    }

private:
    std::optional<lessons::Gauge> m_gauge;
};

// The settings that may be turned, but for those that the hand holds in the picture, and how far the condition is.
class UntilBody : public AnswerBody {
public:
    UntilBody(const lessons::UntilQuestion& question, LessonRun& run, Document& document, QWidget* parent)
        : AnswerBody(parent),
          m_run(run),
          m_bar(new GaugeBar(this)),
          m_said(styled(new QLabel(this), {.name = "gauge", .wraps = true})) {
        auto* form = new QGridLayout;
        form->setColumnStretch(1, 1);
        int row = 0;
        for (const std::string& key : question.free) {
            const auto setting = pipeline::findSetting(document.scene(), key);
            if (!setting || document.hand().isHeld(key)) continue;
            auto* one = new SettingRow(document, *setting, *form, row, this);
            one->setStacked(true);
            if (!m_first) m_first = findChild<QWidget*>(toQString(key));
            row += 3;
        }
        m_column->addLayout(form);
        m_column->addWidget(m_bar);
        m_column->addWidget(m_said);
        connect(&document.frames(), &FrameFeed::frameReady, this, &UntilBody::follow);
        followTheme(this, [this] { m_said->setFont(Theme::current().text(12)); });
        follow();
    }
    std::optional<lessons::Given> given() const override { return lessons::Reached{}; }
    void takeFocus() override {
        if (m_first) m_first->setFocus();
    }
    QString advice() const override {
        return m_first ? tr("Turn the setting, then Enter checks.") : tr("Move it in the picture, then Enter checks.");
    }

private:
    void follow() {
        const auto gauge = m_run.gauge();
        m_bar->set(gauge);
        m_said->setText(gauge ? tr("Now %1").arg(toQString(gauge->said)) : QString());
        m_said->setVisible(gauge.has_value());
    }

    LessonRun& m_run;
    GaugeBar* m_bar;
    QLabel* m_said;
    QWidget* m_first = nullptr;
};

}  // namespace

AnswerBody* makeUntilBody(const lessons::UntilQuestion& question, LessonRun& run, Document& document, QWidget* parent) {
    return new UntilBody(question, run, document, parent);
}

}  // namespace app
