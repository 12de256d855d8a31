#include "app/widgets/error_list.h"

#include <algorithm>

#include <QAccessible>
#include <QClipboard>
#include <QDesktopServices>
#include <QFileInfo>
#include <QGuiApplication>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QPainter>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QUrl>

#include "app/look/icons.h"
#include "app/look/text.h"
#include "app/widgets/follow_theme.h"

namespace app {

ErrorList::ErrorList(QWidget* parent)
    : QFrame(parent),
      m_sentence(styled(new QLabel(this), {.size = 13, .weight = 600, .wraps = true})),
      m_lines(new QPlainTextEdit(this)),
      m_showFile(new QPushButton(tr("Show file"), this)) {
    setObjectName("errorList");
    auto* copy = new QPushButton(tr("Copy"), this);
    auto* close = new QPushButton(tr("Close"), this);
    auto* mark = new QLabel(this);
    auto* top = spaced(new QHBoxLayout, {}, 8);
    top->addWidget(mark);
    top->addWidget(m_sentence, 1);
    top->addWidget(m_showFile);
    top->addWidget(copy);
    top->addWidget(close);
    auto* column = spaced(new QVBoxLayout(this), {16, 8, 8, 8});
    column->addLayout(top);
    column->addWidget(m_lines);
    m_sentence->setTextInteractionFlags(Qt::TextSelectableByMouse);
    m_lines->setReadOnly(true);
    m_lines->setLineWrapMode(QPlainTextEdit::WidgetWidth);
    m_lines->setAccessibleName(tr("Errors"));
    followTheme(this, [this, mark] {
        const Theme& theme = Theme::current();
        m_lines->setFont(theme.mono());
        mark->setPixmap(iconPixmap("warning", theme.colors().failed, theme.px(18), devicePixelRatioF()));
        fit();
    });
    connect(copy, &QPushButton::clicked, this, [this] { QGuiApplication::clipboard()->setText(text()); });
    connect(close, &QPushButton::clicked, this, &QWidget::hide);
    connect(m_showFile, &QPushButton::clicked, this,
            [this] { QDesktopServices::openUrl(QUrl::fromLocalFile(m_file)); });
    hide();
}

void ErrorList::report(const QString& sentence, const pipeline::Errors& errors) {
    m_sentence->setText(sentence);
    m_lines->setPlainText(toQString(format(errors)).trimmed());
    m_file = errors.empty() ? QString() : toQString(errors.front().where.file);
    m_showFile->setVisible(QFileInfo(m_file).isFile());
    setVisible(true);
    fit();
    setAccessibleName(sentence);
    QAccessibleEvent alert(this, QAccessible::Alert);
    QAccessible::updateAccessibility(&alert);
}

QString ErrorList::text() const { return m_sentence->text() + QLatin1Char('\n') + m_lines->toPlainText(); }

// As high as its lines, up to eight of them; the rest scrolls.
void ErrorList::fit() {
    const int lines = std::clamp(int(m_lines->document()->size().height()), 1, 8);  // a plain text's is in lines
    m_lines->setFixedHeight(lines * QFontMetrics(m_lines->font()).lineSpacing() + Theme::current().px(24));
}

void ErrorList::resizeEvent(QResizeEvent* event) {
    QFrame::resizeEvent(event);
    fit();
}

void ErrorList::keyPressEvent(QKeyEvent* event) {
    if (event->key() == Qt::Key_Escape) return hide();
    QFrame::keyPressEvent(event);
}

void ErrorList::paintEvent(QPaintEvent*) {
    const ThemeColors& c = Theme::current().colors();
    QPainter painter(this);
    painter.fillRect(rect(), c.surface);
    painter.fillRect(0, 0, Theme::current().px(4), height(), c.failed);
    painter.setPen(c.line);
    painter.drawLine(0, height() - 1, width(), height() - 1);
}

}  // namespace app
