package org.evoloop.page;

import java.util.List;
import java.util.function.Supplier;
import org.evoloop.converter.SystemEventConverter;

/**
 * A further document of a page's server, for programs rather than people: a module provides it as a service, so it is
 * available if the module is present. Anyone who may look at the page may read it, without the token.
 *
 * <p>Threading: called from any thread.
 *
 * @since 0.1
 */
public interface Document {
    /** Its path, such as {@code /metrics}. */
    String path();

    /** Its media type, such as {@code text/plain; charset=utf-8}. */
    String mediaType();

    /**
     * Prepares it; called at the first request, once for each page.
     *
     * @param converters the console's converters, in order
     * @return supplies its present content, and must not wait
     */
    Supplier<byte[]> of(List<SystemEventConverter> converters);
}
