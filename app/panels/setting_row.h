#pragma once
#include <QWidget>
#include <functional>

#include "app/core/document.h"

class QGridLayout;
class QLabel;

namespace app {

// The control of one setting in a form of three columns: label; slider, buttons or list; number.
// It follows the document. Where the setting has no effect in this scene it is dimmed, and a note
// below says why. Takes two rows of the form.
class SettingRow : public QObject {
    Q_OBJECT
public:
    SettingRow(Document& document, pipeline::SettingRef setting, QGridLayout& form, int row, QWidget* parent);

    bool isIdle() const { return !m_idle.isEmpty(); }
    void setShown(bool shown);

private:
    void addNumber(QGridLayout& form, int row, QWidget* parent);
    void addChoice(QGridLayout& form, int row, QWidget* parent);
    void showScene();
    void showPointed();
    void change(double value, Document::Change kind);

    Document& m_document;
    pipeline::SettingRef m_setting;
    QLabel* m_label = nullptr;
    QLabel* m_note = nullptr;
    QString m_idle;
    bool m_shown = true;
    QList<QWidget*> m_controls;
    std::function<void(double value, std::optional<double> before)> m_show;
};

// "k_r red" as rich text: the symbol in the formulas' letters, the rest as it stands.
QString labelWithSymbol(const QString& label);
// The choice's name for people: "Flat", "Look-at", "At infinity", "Float".
QString choiceName(std::string_view choice);

}  // namespace app
