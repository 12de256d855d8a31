#include "tests/twin/gl_context.h"

#define GL_GLEXT_PROTOTYPES
#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <GL/gl.h>
#include <GL/glext.h>
#include <fmt/format.h>

#include <functional>
#include <map>

namespace twin {
namespace {

using pipeline::GlCall;

const std::map<std::string_view, GLenum> kEnums{
#define SHADESCOPE_NAME(name) {#name, name}
    SHADESCOPE_NAME(GL_AMBIENT),
    SHADESCOPE_NAME(GL_BACK),
    SHADESCOPE_NAME(GL_BLEND),
    SHADESCOPE_NAME(GL_CCW),
    SHADESCOPE_NAME(GL_COLOR_BUFFER_BIT),
    SHADESCOPE_NAME(GL_CONSTANT_ATTENUATION),
    SHADESCOPE_NAME(GL_CULL_FACE),
    SHADESCOPE_NAME(GL_CW),
    SHADESCOPE_NAME(GL_DEPTH_BUFFER_BIT),
    SHADESCOPE_NAME(GL_DEPTH_TEST),
    SHADESCOPE_NAME(GL_DIFFUSE),
    SHADESCOPE_NAME(GL_DITHER),
    SHADESCOPE_NAME(GL_EMISSION),
    SHADESCOPE_NAME(GL_FALSE),
    SHADESCOPE_NAME(GL_FLAT),
    SHADESCOPE_NAME(GL_FRONT),
    SHADESCOPE_NAME(GL_FRONT_AND_BACK),
    SHADESCOPE_NAME(GL_LESS),
    SHADESCOPE_NAME(GL_LIGHT0),
    SHADESCOPE_NAME(GL_LIGHT1),
    SHADESCOPE_NAME(GL_LIGHT2),
    SHADESCOPE_NAME(GL_LIGHT3),
    SHADESCOPE_NAME(GL_LIGHT4),
    SHADESCOPE_NAME(GL_LIGHT5),
    SHADESCOPE_NAME(GL_LIGHT6),
    SHADESCOPE_NAME(GL_LIGHT7),
    SHADESCOPE_NAME(GL_LIGHTING),
    SHADESCOPE_NAME(GL_LIGHT_MODEL_AMBIENT),
    SHADESCOPE_NAME(GL_LIGHT_MODEL_LOCAL_VIEWER),
    SHADESCOPE_NAME(GL_LIGHT_MODEL_TWO_SIDE),
    SHADESCOPE_NAME(GL_LINEAR_ATTENUATION),
    SHADESCOPE_NAME(GL_MODELVIEW),
    SHADESCOPE_NAME(GL_NORMALIZE),
    SHADESCOPE_NAME(GL_ONE_MINUS_SRC_ALPHA),
    SHADESCOPE_NAME(GL_POLYGON),
    SHADESCOPE_NAME(GL_POSITION),
    SHADESCOPE_NAME(GL_PROJECTION),
    SHADESCOPE_NAME(GL_QUADRATIC_ATTENUATION),
    SHADESCOPE_NAME(GL_SHININESS),
    SHADESCOPE_NAME(GL_SMOOTH),
    SHADESCOPE_NAME(GL_SPECULAR),
    SHADESCOPE_NAME(GL_SPOT_CUTOFF),
    SHADESCOPE_NAME(GL_SPOT_DIRECTION),
    SHADESCOPE_NAME(GL_SPOT_EXPONENT),
    SHADESCOPE_NAME(GL_SRC_ALPHA),
    SHADESCOPE_NAME(GL_TRUE),
#undef SHADESCOPE_NAME
};

// A call's arguments as OpenGL wants them.
struct Arguments {
    std::vector<GLenum> names;
    std::vector<double> d;
    std::vector<GLfloat> f;
    explicit Arguments(const GlCall& call) : d(call.numbers), f(call.numbers.begin(), call.numbers.end()) {
        for (const std::string_view name : call.names) names.push_back(kEnums.at(name));
    }
    GLenum name(std::size_t i) const { return names.at(i); }
    GLsizei whole(std::size_t i) const { return GLsizei(d.at(i)); }
};

const std::map<std::string_view, std::function<void(const Arguments&)>> kFunctions{
    {"glBegin", [](const Arguments& a) { glBegin(a.name(0)); }},
    {"glClear",
     [](const Arguments& a) {
         GLbitfield bits = 0;
         for (const GLenum bit : a.names) bits |= bit;
         glClear(bits);
     }},
    {"glClearColor", [](const Arguments& a) { glClearColor(a.f[0], a.f[1], a.f[2], a.f[3]); }},
    {"glCullFace", [](const Arguments& a) { glCullFace(a.name(0)); }},
    {"glBlendFunc", [](const Arguments& a) { glBlendFunc(a.name(0), a.name(1)); }},
    {"glDepthMask", [](const Arguments& a) { glDepthMask(GLboolean(a.name(0))); }},
    {"glDepthFunc", [](const Arguments& a) { glDepthFunc(a.name(0)); }},
    {"glDepthRange", [](const Arguments& a) { glDepthRange(a.d[0], a.d[1]); }},
    {"glDisable", [](const Arguments& a) { glDisable(a.name(0)); }},
    {"glEnable", [](const Arguments& a) { glEnable(a.name(0)); }},
    {"glEnd", [](const Arguments&) { glEnd(); }},
    {"glFrontFace", [](const Arguments& a) { glFrontFace(a.name(0)); }},
    {"glFrustum", [](const Arguments& a) { glFrustum(a.d[0], a.d[1], a.d[2], a.d[3], a.d[4], a.d[5]); }},
    {"glLightModelfv", [](const Arguments& a) { glLightModelfv(a.name(0), a.f.data()); }},
    {"glLightModeli", [](const Arguments& a) { glLightModeli(a.name(0), GLint(a.name(1))); }},
    {"glLightf", [](const Arguments& a) { glLightf(a.name(0), a.name(1), a.f[0]); }},
    {"glLightfv", [](const Arguments& a) { glLightfv(a.name(0), a.name(1), a.f.data()); }},
    {"glLoadIdentity", [](const Arguments&) { glLoadIdentity(); }},
    {"glLoadMatrixd", [](const Arguments& a) { glLoadMatrixd(a.d.data()); }},
    {"glMaterialf", [](const Arguments& a) { glMaterialf(a.name(0), a.name(1), a.f[0]); }},
    {"glMaterialfv", [](const Arguments& a) { glMaterialfv(a.name(0), a.name(1), a.f.data()); }},
    {"glMatrixMode", [](const Arguments& a) { glMatrixMode(a.name(0)); }},
    {"glNormal3d", [](const Arguments& a) { glNormal3d(a.d[0], a.d[1], a.d[2]); }},
    {"glOrtho", [](const Arguments& a) { glOrtho(a.d[0], a.d[1], a.d[2], a.d[3], a.d[4], a.d[5]); }},
    {"glPopMatrix", [](const Arguments&) { glPopMatrix(); }},
    {"glPushMatrix", [](const Arguments&) { glPushMatrix(); }},
    {"glRotated", [](const Arguments& a) { glRotated(a.d[0], a.d[1], a.d[2], a.d[3]); }},
    {"glScaled", [](const Arguments& a) { glScaled(a.d[0], a.d[1], a.d[2]); }},
    {"glShadeModel", [](const Arguments& a) { glShadeModel(a.name(0)); }},
    {"glTranslated", [](const Arguments& a) { glTranslated(a.d[0], a.d[1], a.d[2]); }},
    {"glVertex3d", [](const Arguments& a) { glVertex3d(a.d[0], a.d[1], a.d[2]); }},
    {"glViewport", [](const Arguments& a) { glViewport(a.whole(0), a.whole(1), a.whole(2), a.whole(3)); }},
};

class EglContext final : public GlContext {
public:
    EglContext(EGLDisplay display, EGLContext context) : m_display(display), m_context(context) {}
    ~EglContext() override {
        eglMakeCurrent(m_display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
        eglDestroyContext(m_display, m_context);
        eglTerminate(m_display);
    }
    std::string version() const override { return reinterpret_cast<const char*>(glGetString(GL_VERSION)); }
    std::string renderer() const override { return reinterpret_cast<const char*>(glGetString(GL_RENDERER)); }
    int subPixelBits() const override {
        GLint bits = 0;
        glGetIntegerv(GL_SUBPIXEL_BITS, &bits);
        return bits;
    }

    GlPicture draw(const std::vector<GlCall>& calls, glm::ivec2 size) override {
        GLuint target = 0, buffers[2] = {};
        glGenFramebuffers(1, &target);
        glBindFramebuffer(GL_FRAMEBUFFER, target);
        glGenRenderbuffers(2, buffers);
        const auto attach = [&](GLuint buffer, GLenum format, GLenum where) {
            glBindRenderbuffer(GL_RENDERBUFFER, buffer);
            glRenderbufferStorage(GL_RENDERBUFFER, format, size.x, size.y);
            glFramebufferRenderbuffer(GL_FRAMEBUFFER, where, GL_RENDERBUFFER, buffer);
        };
        attach(buffers[0], GL_RGBA8, GL_COLOR_ATTACHMENT0);
        attach(buffers[1], GL_DEPTH_COMPONENT24, GL_DEPTH_ATTACHMENT);

        GlPicture picture{size, {}, {}, {}, {}};
        if (glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
            picture.error = "the framebuffer is not complete";
        carryOut(calls, false, picture.error);
        readColor(picture, [&](const GLubyte* p) { picture.color.emplace_back(p[0], p[1], p[2]); });
        readDepth(picture);
        carryOut(calls, true, picture.error);
        readColor(picture, [&](const GLubyte* p) { picture.polygon.push_back((p[0] << 16 | p[1] << 8 | p[2]) - 1); });

        glBindFramebuffer(GL_FRAMEBUFFER, 0);
        glDeleteFramebuffers(1, &target);
        glDeleteRenderbuffers(2, buffers);
        return picture;
    }

private:
    static void carryOut(const std::vector<GlCall>& calls, bool identify, std::string& error) {
        int polygon = 0;
        bool within = false;
        for (const GlCall& call : calls) {
            // object and polygon are those of the opaque surfaces.
            if (identify && call.function == "glEnable" && call.names[0] == "GL_BLEND") break;
            const bool begins = call.function == "glBegin", ends = call.function == "glEnd";
            if (identify && begins) {
                ++polygon;
                glDisable(GL_LIGHTING);
                glColor3ub(GLubyte(polygon >> 16), GLubyte(polygon >> 8), GLubyte(polygon));
            }
            kFunctions.at(call.function)(Arguments(call));
            within = (within || begins) && !ends;
            // Between glBegin and glEnd to ask is an error of its own.
            if (within) continue;
            if (const GLenum code = glGetError(); code != GL_NO_ERROR && error.empty())
                error = fmt::format("{} gives error {:#x}", pipeline::toC(call), code);
        }
        glFinish();
    }

    template <class Take>
    static void readColor(const GlPicture& picture, Take take) {
        const auto width = std::size_t(picture.size.x);
        std::vector<GLubyte> rgba(width * std::size_t(picture.size.y) * 4);
        glReadPixels(0, 0, picture.size.x, picture.size.y, GL_RGBA, GL_UNSIGNED_BYTE, rgba.data());
        for (int y = picture.size.y; y-- > 0;)
            for (std::size_t x = 0; x < width; ++x) take(&rgba[(std::size_t(y) * width + x) * 4]);
    }

    static void readDepth(GlPicture& picture) {
        const auto width = std::size_t(picture.size.x);
        std::vector<GLuint> depth(width * std::size_t(picture.size.y));
        glReadPixels(0, 0, picture.size.x, picture.size.y, GL_DEPTH_COMPONENT, GL_UNSIGNED_INT, depth.data());
        for (int y = picture.size.y; y-- > 0;)
            for (std::size_t x = 0; x < width; ++x)
                picture.depth.push_back(double(depth[std::size_t(y) * width + x]) / 4294967295.0);
    }

    EGLDisplay m_display;
    EGLContext m_context;
};

}  // namespace

std::unique_ptr<GlContext> GlContext::make(std::string& whyNot) {
    EGLDisplay display = eglGetPlatformDisplay(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
    if (display == EGL_NO_DISPLAY) display = eglGetDisplay(EGL_DEFAULT_DISPLAY);
    if (display == EGL_NO_DISPLAY || !eglInitialize(display, nullptr, nullptr)) {
        whyNot = "no EGL display";
        return nullptr;
    }
    EGLContext context = EGL_NO_CONTEXT;
    if (eglBindAPI(EGL_OPENGL_API)) context = eglCreateContext(display, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, nullptr);
    if (context == EGL_NO_CONTEXT || !eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, context)) {
        whyNot = "EGL makes no OpenGL context without a surface";
        eglTerminate(display);
        return nullptr;
    }
    auto made = std::make_unique<EglContext>(display, context);
    // A core context has no fixed functions.
    glMatrixMode(GL_MODELVIEW);
    if (glGetError() != GL_NO_ERROR) {
        whyNot = "this OpenGL has no compatibility context";
        return nullptr;
    }
    return made;
}

}  // namespace twin
