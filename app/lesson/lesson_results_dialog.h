#pragma once
#include <QDialog>

#include "app/lesson/lesson_results.h"
#include "app/lesson/lesson_shelf.h"

namespace app {

// What was tried on every page of every lesson, as the results have it.
class LessonResultsDialog : public QDialog {
    Q_OBJECT
public:
    static void showResults(LessonShelf& shelf, const LessonResults& results,
                            QWidget* parent);  // and goes when it is closed

private:
    LessonResultsDialog(LessonShelf& shelf, const LessonResults& results, QWidget* parent);
};

}  // namespace app
