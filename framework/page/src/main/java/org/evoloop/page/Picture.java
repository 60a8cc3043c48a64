package org.evoloop.page;

import java.util.function.Supplier;

/**
 * A picture that the page shows beside the models, such as a room or a camera's view. It is requested repeatedly while
 * there are viewers.
 *
 * <p>Threading: {@code view} is called from any thread, and must not wait.
 *
 * @param name its title
 * @param description a text alternative
 * @param mediaType {@code image/svg+xml}, {@code image/jpeg} or {@code image/png}
 * @param isPrivate whether only those see it who have the page's token, as with what a camera sees in a home
 * @param view supplies the present picture
 * @since 0.1
 */
public record Picture(String name, String description, String mediaType, boolean isPrivate, Supplier<View> view) {

    /** A picture that everybody sees who sees the page. */
    public Picture(String name, String description, String mediaType, Supplier<View> view) {
        this(name, description, mediaType, false, view);
    }

    /**
     * What there is to see at one moment.
     *
     * @param content the picture; empty if there is none
     * @param note a line below it, such as its age, or why there is none; empty for nothing to say
     */
    @SuppressWarnings("ArrayRecordComponent") // The page only sends the bytes.
    public record View(byte[] content, String note) {

        /** A picture that needs no words; empty for none. */
        public static View of(byte[] content) {
            return new View(content, content.length == 0 ? "No picture yet." : "");
        }
    }
}
