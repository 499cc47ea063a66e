/**
 * What a light sees of a hierarchy's boxes, by direction (Haines and Greenberg, The Light Buffer, 1986):
 * what may be in a ray's way is found in one cell. A search asks a {@link
 * raytracer.tracer.lightbuffer.LazyLightBuffer}, which builds one when the work ahead pays for it. Must not know:
 * surfaces, but as shapes that bound them.
 */
package raytracer.tracer.lightbuffer;
