#include "app/look/style_sheet.h"

#include <QRegularExpression>

namespace app {

namespace {

// @name is a colour of the theme, a number with "u" a length that grows with the font scale;
// hairlines are in px and do not.
constexpr const char* kTemplate = R"(
* { outline: 0; }
QMainWindow, QDialog { background: @bg; }
QMainWindow::separator { background: @bg; width: 8u; height: 8u; }
QToolBar { background: @surface; border: 1px solid @line; border-radius: 6u; padding: 4u; }
QToolTip { background: @raised; color: @text; border: 1px solid @outline; padding: 4u; }
QLabel { background: transparent; color: @text; }
QLabel[tone="2"] { color: @text2; }
QLabel[tone="3"] { color: @text3; }
QFrame[kind="panel"] { background: @surface; border: 1px solid @line; border-radius: 6u; }
QFrame[kind="panel"][active="true"] { border-color: @accent; }
QWidget[kind="page"] { background: @surface; }
QFrame[kind="overlay"] { background: @surface; border: 1px solid @line; border-radius: 4u; }

QMenuBar { background: @bg; color: @text2; padding: 2u 6u; }
QMenuBar::item { background: transparent; padding: 4u 9u; border-radius: 4u; }
QMenuBar::item:selected { background: @hover; color: @text; }
QMenu { background: @raised; color: @text; border: 1px solid @outline; padding: 4u; }
QMenu::item { padding: 4u 24u 4u 24u; border-radius: 4u; }
QMenu::item:selected { background: @tint; }
QMenu::item:disabled { color: @text3; }
QMenu::separator { height: 1px; background: @line; margin: 4u 8u; }
QMenu::indicator { width: 14u; height: 14u; left: 6u; }

QPushButton { background: @raised; color: @text; border: 1px solid @outline; border-radius: 4u;
  padding: 0 12u; min-height: 24u; }
QPushButton:hover, QToolButton:hover { background: @hover; }
QPushButton:pressed, QToolButton:pressed { background: @tint; }
QPushButton:checked { background: @tint; color: @accent; border-color: @accent; }
QPushButton:disabled, QToolButton:disabled { color: @text3; }
QPushButton:disabled { border-color: @line; }
QPushButton[kind="primary"] { background: @fill; color: @onFill; border-color: @fill; }
QPushButton[kind="primary"]:disabled { background: @raised; color: @text3; border-color: @line; }
QPushButton[kind="link"] { background: transparent; color: @accent; border: 1px solid transparent; padding: 0 2u;
  min-height: 20u; text-align: left; }
QToolButton { background: transparent; color: @text2; border: 1px solid transparent; border-radius: 4u;
  padding: 2u; min-width: 18u; min-height: 18u; }
QToolButton:checked { background: @tint; color: @accent; }
QToolButton[kind="fold"], QToolButton[kind="fold"]:checked { background: transparent; color: @text; padding: 2u 4u 2u 0; }
QToolButton[kind="fold"]:hover { color: @accent; }
QToolButton[kind="strip"] { background: @raised; border: 1px solid @outline; padding: 0; min-width: 0; min-height: 0; }
QToolButton[kind="strip"]:checked { background: @fill; color: @onFill; border-color: @fill; }
QToolButton::menu-indicator { image: none; }
QToolButton[kind="segment"], QPushButton[kind="segment"] { background: @raised; color: @text2;
  border: 1px solid @outline; border-radius: 0; padding: 0 10u; min-height: 22u; }
QToolButton[kind="segment"]:checked, QPushButton[kind="segment"]:checked { background: @fill; color: @onFill;
  border-color: @fill; }
QPushButton[kind="segment"]:checked:disabled { background: @hover; color: @text3; border-color: @outline; }

QLineEdit, QComboBox, QAbstractSpinBox, QPlainTextEdit, QTextEdit, QTextBrowser { background: @raised;
  border: 1px solid @outline; border-radius: 4u; padding: 0 6u;
  selection-background-color: @fill; selection-color: @onFill; }
QLineEdit, QComboBox, QAbstractSpinBox { min-height: 22u; }
QLineEdit:disabled, QComboBox:disabled, QAbstractSpinBox:disabled { color: @text3; border-color: @line; }
QComboBox::drop-down { border: 0; width: 20u; }
QComboBox::down-arrow { image: url(:/icons/control-chevron.svg); width: 12u; height: 12u; }
QComboBox QAbstractItemView { background: @raised; color: @text; border: 1px solid @outline;
  selection-background-color: @tint; selection-color: @text; }
QAbstractSpinBox::up-button, QAbstractSpinBox::down-button { width: 0; border: 0; }

QCheckBox, QRadioButton { color: @text; spacing: 8u; background: transparent; }
QCheckBox::indicator, QMenu::indicator, QAbstractItemView::indicator { width: 14u; height: 14u;
  border: 1px solid @outline; border-radius: 3u; background: @raised; }
QCheckBox::indicator:checked, QMenu::indicator:checked, QAbstractItemView::indicator:checked { background: @fill;
  border-color: @fill; image: url(:/icons/control-check.svg); }
QCheckBox:disabled, QRadioButton:disabled { color: @text3; }

QLabel[pointed="true"] { background: @tint; border-radius: 4u; }
QSlider { background: transparent; }
QSlider::groove:horizontal { height: 4u; border-radius: 2u; background: @hover; }
QSlider::sub-page:horizontal { height: 4u; border-radius: 2u; background: @accent; }
QSlider::handle:horizontal { width: 10u; height: 10u; margin: -5u 0; border-radius: 7u;
  border: 2px solid @accent; background: @raised; }
QSlider::sub-page:horizontal:disabled { background: @outline; }
QSlider::handle:horizontal:disabled { border-color: @outline; }

QTabBar { background: transparent; }
QTabBar::tab { background: transparent; color: @text3; padding: 6u 8u; border-bottom: 2px solid transparent; }
QTabBar::tab:selected { color: @text; border-bottom-color: @accent; }
QTabBar::tab:hover { color: @text; }
QTabWidget::pane { border: 0; border-top: 1px solid @line; }

QAbstractScrollArea { background: @surface; border: 0; }
QScrollArea[kind="fields"] { background: @bg; }
QAbstractItemView { background: @surface; color: @text; border: 2px solid transparent; alternate-background-color: @surface;
  selection-background-color: @tint; selection-color: @text; }
QAbstractItemView::item { min-height: 24u; }
QTreeView::item { border: 0; } /* else the text of a row stands where a check box of the usual size ends */
QAbstractItemView::item:hover { background: @hover; }
QAbstractItemView::item:selected { background: @tint; color: @text; }
QHeaderView { background: @surface; }
QHeaderView::section { background: @surface; color: @text3; border: 0; border-bottom: 1px solid @line; padding: 4u 8u; }
QScrollBar:vertical { background: transparent; width: 10u; margin: 0; }
QScrollBar:horizontal { background: transparent; height: 10u; margin: 0; }
QScrollBar::handle { background: @outline; border-radius: 3u; margin: 2u; min-width: 24u; min-height: 24u; }
QScrollBar::add-line, QScrollBar::sub-line { width: 0; height: 0; }
QScrollBar::add-page, QScrollBar::sub-page { background: transparent; }

QDockWidget { color: @text; titlebar-close-icon: none; }
QDockWidget::title { background: @surface; padding: 8u 12u; border-bottom: 1px solid @line; }
QSplitter::handle { background: @bg; }
QProgressBar { background: @hover; color: @text; border: 0; border-radius: 2u; text-align: center; }
QProgressBar::chunk { background: @accent; border-radius: 2u; }
QStatusBar { background: @bg; color: @text2; border-top: 1px solid @line; }
QStatusBar::item { border: 0; }

QPushButton:focus, QToolButton:focus, QLineEdit:focus, QComboBox:focus, QAbstractSpinBox:focus, QTabBar::tab:focus,
QPlainTextEdit:focus, QTextBrowser:focus { border: 2px solid @focus; }
QPushButton[kind="segment"]:checked:focus, QToolButton[kind="segment"]:checked:focus { border-color: @text; }
QTabBar::tab:focus { padding: 4u 6u 6u 6u; }
QAbstractItemView:focus { border-color: @focus; }
QSlider:focus { border: 2px solid @focus; border-radius: 4u; }
QCheckBox:focus, QRadioButton:focus { border: 2px solid @focus; border-radius: 4u; }
)";

}  // namespace

QString styleSheet(const ThemeColors& c, const std::function<int(double)>& px) {
    const std::pair<const char*, QColor> colors[]{
        {"bg", c.bg},         {"surface", c.surface}, {"raised", c.raised}, {"hover", c.hover}, {"view", c.view},
        {"line", c.line},     {"outline", c.outline}, {"text", c.text},     {"text2", c.text2}, {"text3", c.text3},
        {"accent", c.accent}, {"fill", c.fill},       {"onFill", c.onFill}, {"tint", c.tint},   {"focus", c.focus}};
    static const QRegularExpression token("@([A-Za-z0-9]+)|(-?[0-9]+)u\\b");
    const QString source = QString::fromLatin1(kTemplate);
    QString sheet;
    qsizetype end = 0;
    for (auto it = token.globalMatch(source); it.hasNext();) {
        const auto match = it.next();
        sheet += source.mid(end, match.capturedStart() - end);
        end = match.capturedEnd();
        if (match.capturedLength(1) == 0) {
            sheet += QString::number(px(match.captured(2).toInt())) + "px";
        } else {
            for (const auto& [name, color] : colors)
                if (match.captured(1) == QLatin1String(name)) sheet += color.name();
        }
    }
    return sheet + source.mid(end);
}

}  // namespace app
