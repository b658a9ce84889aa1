#pragma once
#include <GL/gl.h>
#include <GL/glext.h>

#include <stdexcept>
#include <string>

#include "render/gl/module/maker.h"

namespace flatray::gl {

/// The functions of OpenGL 3.3 that are used, fetched one by one: nothing is linked.
struct Functions {
// FLATRAY_GL_FUNCTION(member, type, name)
#define FLATRAY_GL_FUNCTIONS(X)                                                           \
  X(get_string, decltype(&::glGetString), "glGetString")                                  \
  X(get_integers, decltype(&::glGetIntegerv), "glGetIntegerv")                            \
  X(get_error, decltype(&::glGetError), "glGetError")                                     \
  X(enable, decltype(&::glEnable), "glEnable")                                            \
  X(disable, decltype(&::glDisable), "glDisable")                                         \
  X(clear, decltype(&::glClear), "glClear")                                               \
  X(clear_colour, decltype(&::glClearColor), "glClearColor")                              \
  X(colour_mask, decltype(&::glColorMask), "glColorMask")                                 \
  X(blend, decltype(&::glBlendFunc), "glBlendFunc")                                       \
  X(viewport, decltype(&::glViewport), "glViewport")                                      \
  X(stencil_func, decltype(&::glStencilFunc), "glStencilFunc")                            \
  X(draw_arrays, decltype(&::glDrawArrays), "glDrawArrays")                               \
  X(read_pixels, decltype(&::glReadPixels), "glReadPixels")                               \
  X(clamp_colour, PFNGLCLAMPCOLORPROC, "glClampColor")                                    \
  X(stencil_op_of, PFNGLSTENCILOPSEPARATEPROC, "glStencilOpSeparate")                     \
  X(gen_framebuffers, PFNGLGENFRAMEBUFFERSPROC, "glGenFramebuffers")                      \
  X(bind_framebuffer, PFNGLBINDFRAMEBUFFERPROC, "glBindFramebuffer")                      \
  X(delete_framebuffers, PFNGLDELETEFRAMEBUFFERSPROC, "glDeleteFramebuffers")             \
  X(framebuffer_status, PFNGLCHECKFRAMEBUFFERSTATUSPROC, "glCheckFramebufferStatus")      \
  X(attach, PFNGLFRAMEBUFFERRENDERBUFFERPROC, "glFramebufferRenderbuffer")                \
  X(blit, PFNGLBLITFRAMEBUFFERPROC, "glBlitFramebuffer")                                  \
  X(gen_renderbuffers, PFNGLGENRENDERBUFFERSPROC, "glGenRenderbuffers")                   \
  X(bind_renderbuffer, PFNGLBINDRENDERBUFFERPROC, "glBindRenderbuffer")                   \
  X(delete_renderbuffers, PFNGLDELETERENDERBUFFERSPROC, "glDeleteRenderbuffers")          \
  X(storage, PFNGLRENDERBUFFERSTORAGEMULTISAMPLEPROC, "glRenderbufferStorageMultisample") \
  X(gen_vertex_arrays, PFNGLGENVERTEXARRAYSPROC, "glGenVertexArrays")                     \
  X(bind_vertex_array, PFNGLBINDVERTEXARRAYPROC, "glBindVertexArray")                     \
  X(delete_vertex_arrays, PFNGLDELETEVERTEXARRAYSPROC, "glDeleteVertexArrays")            \
  X(gen_buffers, PFNGLGENBUFFERSPROC, "glGenBuffers")                                     \
  X(bind_buffer, PFNGLBINDBUFFERPROC, "glBindBuffer")                                     \
  X(delete_buffers, PFNGLDELETEBUFFERSPROC, "glDeleteBuffers")                            \
  X(buffer_data, PFNGLBUFFERDATAPROC, "glBufferData")                                     \
  X(attribute, PFNGLVERTEXATTRIBPOINTERPROC, "glVertexAttribPointer")                     \
  X(enable_attribute, PFNGLENABLEVERTEXATTRIBARRAYPROC, "glEnableVertexAttribArray")      \
  X(create_shader, PFNGLCREATESHADERPROC, "glCreateShader")                               \
  X(shader_source, PFNGLSHADERSOURCEPROC, "glShaderSource")                               \
  X(compile_shader, PFNGLCOMPILESHADERPROC, "glCompileShader")                            \
  X(delete_shader, PFNGLDELETESHADERPROC, "glDeleteShader")                               \
  X(create_program, PFNGLCREATEPROGRAMPROC, "glCreateProgram")                            \
  X(attach_shader, PFNGLATTACHSHADERPROC, "glAttachShader")                               \
  X(link_program, PFNGLLINKPROGRAMPROC, "glLinkProgram")                                  \
  X(program_value, PFNGLGETPROGRAMIVPROC, "glGetProgramiv")                               \
  X(use_program, PFNGLUSEPROGRAMPROC, "glUseProgram")                                     \
  X(delete_program, PFNGLDELETEPROGRAMPROC, "glDeleteProgram")                            \
  X(uniform_place, PFNGLGETUNIFORMLOCATIONPROC, "glGetUniformLocation")                   \
  X(set_floats, PFNGLUNIFORM2FPROC, "glUniform2f")                                        \
  X(set_integers, PFNGLUNIFORM2IPROC, "glUniform2i")                                      \
  X(set_integer, PFNGLUNIFORM1IPROC, "glUniform1i")                                       \
  X(active_texture, PFNGLACTIVETEXTUREPROC, "glActiveTexture")                            \
  X(gen_textures, decltype(&::glGenTextures), "glGenTextures")                            \
  X(bind_texture, decltype(&::glBindTexture), "glBindTexture")                            \
  X(delete_textures, decltype(&::glDeleteTextures), "glDeleteTextures")                   \
  X(texture_buffer, PFNGLTEXBUFFERPROC, "glTexBuffer")                                    \
  X(image, decltype(&::glTexImage2D), "glTexImage2D")                                     \
  X(parameter, decltype(&::glTexParameteri), "glTexParameteri")                           \
  X(image_of_samples, PFNGLTEXIMAGE2DMULTISAMPLEPROC, "glTexImage2DMultisample")          \
  X(attach_texture, PFNGLFRAMEBUFFERTEXTURE2DPROC, "glFramebufferTexture2D")              \
  X(sample_mask, PFNGLSAMPLEMASKIPROC, "glSampleMaski")
#define FLATRAY_GL_MEMBER(member, type, name) type member = nullptr;
  FLATRAY_GL_FUNCTIONS(FLATRAY_GL_MEMBER)
#undef FLATRAY_GL_MEMBER

  void load(const Maker& maker) {
#define FLATRAY_GL_LOAD(member, type, name)              \
  member = reinterpret_cast<type>(maker.function(name)); \
  if (member == nullptr) throw std::runtime_error(std::string("this GL has no ") + name);
    FLATRAY_GL_FUNCTIONS(FLATRAY_GL_LOAD)
#undef FLATRAY_GL_LOAD
  }
#undef FLATRAY_GL_FUNCTIONS
};

}  // namespace flatray::gl
