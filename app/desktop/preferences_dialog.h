#pragma once
#include <QDialog>

class QFormLayout;
class QLabel;
class QSpinBox;

namespace app {

class Segmented;

// The user's preferences: theme, text size, the format of numbers, what is saved, and where. A choice applies at once,
// and is saved.
class PreferencesDialog : public QDialog {
    Q_OBJECT
public:
    explicit PreferencesDialog(QWidget* parent);

signals:
    void keysAsked();

private:
    void addLook(QFormLayout& form);
    void addNumbers(QFormLayout& form);
    void addScenes(QFormLayout& form);
    void addFiles(QFormLayout& form);
    void takeNumbers();
    void showValues();

    Segmented *m_theme, *m_form;
    QSpinBox *m_letters, *m_digits, *m_power;
    QLabel* m_sample;
};

}  // namespace app
