package org.evoloop.xmi.dialect;

import java.nio.charset.Charset;
import java.nio.charset.StandardCharsets;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * Finds the encoding that a document announces in its first bytes (XML 1.0, appendix F). The parser could find it
 * itself, but writes complaints about wrong bytes to standard error.
 */
final class XmlEncoding {
    /** Longer than any XML declaration needs to be. */
    static final int HEAD_BYTES = 256;

    private static final Pattern DECLARATION =
            Pattern.compile("^<\\?xml\\s[^>]*?encoding\\s*=\\s*[\"']([A-Za-z0-9._-]+)[\"']");

    private XmlEncoding() {}

    /** The length of a UTF-8 byte order mark, which Java's decoder would treat as text. */
    static int utf8MarkBytes(byte[] head) {
        return head.length >= 3 && (head[0] & 0xFF) == 0xEF && (head[1] & 0xFF) == 0xBB && (head[2] & 0xFF) == 0xBF
                ? 3
                : 0;
    }

    /** @throws IllegalArgumentException if the document announces an encoding that this Java does not know */
    static Charset of(byte[] head) {
        int firstTwo = head.length < 2 ? 0 : (head[0] & 0xFF) << 8 | (head[1] & 0xFF);
        switch (firstTwo) {
            case 0xFEFF, 0xFFFE -> {
                return StandardCharsets.UTF_16;
            }
            case 0x003C -> {
                return StandardCharsets.UTF_16BE;
            }
            case 0x3C00 -> {
                return StandardCharsets.UTF_16LE;
            }
            default -> {
                Matcher declaration = DECLARATION.matcher(new String(head, StandardCharsets.ISO_8859_1));
                return declaration.find() ? Charset.forName(declaration.group(1)) : StandardCharsets.UTF_8;
            }
        }
    }
}
