#include "app/docks/window_centre.h"

#include <QLabel>
#include <QStackedWidget>
#include <QVBoxLayout>

#include "app/look/theme.h"
#include "app/start/start_page.h"
#include "app/views/view_area.h"
#include "app/widgets/error_list.h"
#include "app/widgets/follow_theme.h"

namespace app {

WindowCentre::WindowCentre(Document& document, QWidget* parent)
    : QWidget(parent),
      m_errors(new ErrorList(this)),
      m_banner(new QLabel(this)),
      m_pages(new QStackedWidget(this)),
      m_start(new StartPage(m_pages)),
      m_views(new ViewArea(document, m_pages)) {
    auto* column = spaced(new QVBoxLayout(this), {}, 8);
    m_banner->setObjectName("banner");
    m_banner->hide();
    m_pages->addWidget(m_start);
    m_pages->addWidget(m_views);
    column->addWidget(m_errors);
    column->addWidget(m_banner);
    column->addWidget(m_pages, 1);
}

}  // namespace app
