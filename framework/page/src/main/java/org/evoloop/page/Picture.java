package org.evoloop.page;

import java.util.function.Supplier;

/**
 * Something that the page shows beside the models, such as a room or what a camera sees. It is asked for again and
 * again while somebody looks.
 *
 * <p>Threading: {@code content} is called from any thread, and must not wait.
 *
 * @param name what stands above it
 * @param description what it shows, for who does not see it
 * @param mediaType {@code image/svg+xml}, {@code image/jpeg} or {@code image/png}
 * @param content the picture as it is now; empty if there is none
 * @since 0.1
 */
public record Picture(String name, String description, String mediaType, Supplier<byte[]> content) {}
