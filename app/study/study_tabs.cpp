#include "app/study/study_tabs.h"

#include <QLayout>
#include <QScrollArea>

#include "app/study/study_details.h"
#include "app/study/study_pictures.h"
#include "app/study/study_words.h"
#include "app/widgets/follow_theme.h"
#include "app/widgets/surface.h"

namespace app {

StudyTabs::StudyTabs(StudyPicturesView& pictures, QWidget& frame, QWidget* parent)
    : QTabWidget(parent), m_pictures(pictures), m_frame(frame), m_details(new StudyDetails), m_words(new StudyWords) {
    setObjectName("studyTabs");
    m_words->setProperty("kind", "page");
    addTab(scrolling(m_details, this), tr("Details"));
    addTab(scrolling(m_words, this), tr("Answers"));
}

void StudyTabs::setLow(bool isLow) {
    if (isLow == (count() > 2)) return;
    if (isLow) {
        insertTab(0, &m_pictures, tr("Pictures"));
        insertTab(2, scrolling(&m_details->blame(), this), tr("Blame"));
        insertTab(3, &m_details->errors(), tr("Buffers"));
        setTabVisible(1, false);
        setCurrentIndex(0);
    } else {
        auto* blame = static_cast<QScrollArea*>(widget(2));
        blame->takeWidget();
        delete blame;
        m_details->unite();
        m_frame.layout()->addWidget(&m_pictures);
        m_pictures.show();
        setTabVisible(0, true);
        setCurrentIndex(0);
    }
    m_frame.setVisible(!isLow);
    // Qt's style sheets take the fonts of what gets another parent.
    followThemeAgain(m_pictures), followThemeAgain(*m_details);
}

}  // namespace app
