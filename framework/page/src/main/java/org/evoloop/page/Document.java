package org.evoloop.page;

import java.util.List;
import java.util.function.Supplier;
import org.evoloop.converter.SystemEventConverter;

/**
 * Something else that a page's server answers, for programs rather than people: a module provides it as a service, and
 * whoever has the module has it. Whoever may look at the page may read it, without the token.
 *
 * <p>Threading: called from any thread.
 *
 * @since 0.1
 */
public interface Document {
    /** Where it is, such as {@code /metrics}. */
    String path();

    /** Its media type, such as {@code text/plain; charset=utf-8}. */
    String mediaType();

    /**
     * Prepares it; called when it is asked for first, once for each page.
     *
     * @param converters those of the console, the first one first
     * @return gives its content as it is now, and must not wait
     */
    Supplier<byte[]> of(List<SystemEventConverter> converters);
}
