// Dear ImGui's OpenGL backend opens libGL.so.1 by itself and asks it for glXGetProcAddressARB. Tests draw
// with OSMesa, which cannot live beside the real libGL: this stands in its place, under its name.
#include <GL/osmesa.h>

extern "C" __attribute__((visibility("default"))) OSMESAproc glXGetProcAddressARB(const unsigned char* name) {
  return OSMesaGetProcAddress(reinterpret_cast<const char*>(name));
}
