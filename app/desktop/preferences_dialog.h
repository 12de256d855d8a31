#pragma once
#include <QDialog>

class QFormLayout;
class QLabel;
class QSpinBox;

namespace app {

class Segmented;

// What is the user's and not the scene's: the look of the window, how numbers are written, what is kept, and where. A
// choice holds at once, and is kept.
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
