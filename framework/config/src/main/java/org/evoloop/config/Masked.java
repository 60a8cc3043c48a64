package org.evoloop.config;

import java.util.regex.Pattern;

/**
 * What others may see of a value or a message that contains it.
 *
 * @since 0.1
 */
public final class Masked {
    /** A user and a password before a host; a port is none. */
    private static final Pattern LOGIN =
            Pattern.compile("([A-Za-z][A-Za-z0-9+.-]*:/+[^\\s/?#@:'\"]*):(?![0-9]{1,5}(?:[/?#\\s]|$))\\S*@");

    private Masked() {}

    /** The text with {@code ***} in place of the passwords in URLs. */
    public static String urls(String text) {
        return LOGIN.matcher(text).replaceAll("$1:***@");
    }
}
