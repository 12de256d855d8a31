#pragma once
#include <QTabWidget>

namespace app {

class StudyDetails;
class StudyPicturesView;
class StudyWords;

// Below the points of a study: what is known of the selected one, in a low window its pictures too; and the
// answers of all.
class StudyTabs : public QTabWidget {
    Q_OBJECT
public:
    // frame: where the pictures stand in a high window.
    StudyTabs(StudyPicturesView& pictures, QWidget& frame, QWidget* parent = nullptr);

    StudyDetails& details() { return *m_details; }
    StudyWords& words() { return *m_words; }
    // In a low window the pictures stand with the details, one at a time; else in their frame.
    void setLow(bool isLow);

private:
    StudyPicturesView& m_pictures;
    QWidget& m_frame;
    StudyDetails* m_details;
    StudyWords* m_words;
};

}  // namespace app
