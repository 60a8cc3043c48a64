package org.evoloop.page;

import java.util.function.Supplier;

/**
 * A picture that the page shows beside the models, such as a room or a camera's view. It is requested repeatedly while
 * there are viewers.
 *
 * <p>Threading: {@code content} is called from any thread, and must not wait.
 *
 * @param name its title
 * @param description a text alternative
 * @param mediaType {@code image/svg+xml}, {@code image/jpeg} or {@code image/png}
 * @param content supplies the present picture; empty if there is none
 * @since 0.1
 */
public record Picture(String name, String description, String mediaType, Supplier<byte[]> content) {}
