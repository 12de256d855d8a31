#include "app/panels/terms_section.h"

#include <QPainter>
#include <algorithm>
#include <cmath>

#include "app/core/numbers.h"
#include "app/panels/follow_theme.h"

namespace app {

TermsSection::TermsSection(QWidget* parent) : QWidget(parent) {
    setAccessibleName(tr("Terms of the intensity"));
    setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Fixed);
    followTheme(this, [this] {
        updateGeometry();
        update();
    });
}

int TermsSection::rowHeight() const { return Theme::current().px(24); }

QSize TermsSection::sizeHint() const {
    return {Theme::current().px(320), (int(m_terms.size()) + 1) * rowHeight() + Theme::current().px(2)};
}

void TermsSection::show(const pipeline::PixelReport& report, int channel) {
    m_terms = {{tr("ambient"), report.ambient[channel]}};
    for (std::size_t k = 0; k < report.diffuse.size(); ++k) {
        m_terms.push_back({tr("diffuse %1").arg(k), report.diffuse[k][channel]});
        m_terms.push_back({tr("specular %1").arg(k), report.specular[k][channel]});
    }
    if (report.emission[channel] != 0) m_terms.push_back({tr("emission"), report.emission[channel]});
    m_intensity = report.intensity[channel];
    setAccessibleDescription(sentence());
    updateGeometry();
    update();
}

double TermsSection::sum() const {
    double sum = 0;
    for (const Term& term : m_terms) sum += term.value;
    return sum;
}

QString TermsSection::sentence() const {
    QStringList parts;
    for (const Term& term : m_terms) parts << term.name + ' ' + intensity(term.value);
    return parts.join(", ");
}

void TermsSection::paintEvent(QPaintEvent*) {
    const Theme& theme = Theme::current();
    const ThemeColors& c = theme.colors();
    QPainter painter(this);
    const QFont text = theme.text(12), digits = theme.mono(12);
    int nameWidth = 0;
    for (const Term& term : m_terms) nameWidth = std::max(nameWidth, QFontMetrics(text).horizontalAdvance(term.name));
    const int valueWidth = QFontMetrics(digits).horizontalAdvance("00 000.000"), gap = theme.px(10);
    const int barLeft = nameWidth + gap, barWidth = std::max(0, width() - barLeft - valueWidth - gap);
    const double whole = std::max(std::abs(m_intensity), std::abs(sum()));
    int y = 0;
    for (const Term& term : m_terms) {
        const QRect row(0, y, width(), rowHeight());
        painter.setFont(text);
        painter.setPen(c.text);
        painter.drawText(row, Qt::AlignVCenter | Qt::AlignLeft, term.name);
        QRectF bar(barLeft, y + (rowHeight() - theme.px(10)) / 2, barWidth, theme.px(10));
        painter.setPen(Qt::NoPen);
        painter.setBrush(c.hover);
        painter.drawRoundedRect(bar, 2, 2);
        if (whole > 0 && term.value > 0) {
            bar.setWidth(std::max(1.0, bar.width() * std::min(1.0, term.value / whole)));
            painter.setBrush(c.text2);
            painter.drawRect(bar);
        }
        painter.setFont(digits);
        painter.setPen(c.text);
        painter.drawText(row, Qt::AlignVCenter | Qt::AlignRight, intensity(term.value));
        y += rowHeight();
    }
    const QRect row(0, y, width(), rowHeight());
    auto write = [&, x = 0](const QFont& font, const QColor& color, const QString& words) mutable {
        painter.setFont(font);
        painter.setPen(color);
        painter.drawText(row.adjusted(x, 0, 0, 0), Qt::AlignVCenter | Qt::AlignLeft, words);
        x += painter.fontMetrics().horizontalAdvance(words) + theme.px(6);
    };
    // Adding up in another order than the stage did costs a few last digits.
    const bool isZero = std::abs(residual()) <= 1e-6 * whole;
    write(text, c.text2, tr("Sum"));
    write(digits, c.text, intensity(sum()));
    write(text, c.text2, tr("residual"));
    write(digits, isZero ? c.run : c.failed, isZero ? QString("0") : errorText(residual()));
}

}  // namespace app
