package org.evoloop.models.diagram;

import java.util.ArrayList;
import java.util.List;

/**
 * Measures text. The widths are those of DejaVu Sans, one of the widest common fonts: text then fits on every machine,
 * and pictures are the same wherever they are made.
 */
final class TextSize {
    static final double FONT_SIZE = 13;
    static final double LINE_HEIGHT = 17;

    /** From the top of a line to its baseline. */
    static final double ASCENT = 12.75;

    /** The widths of space to tilde, in hundredths of the font size. */
    private static final int[] WIDTHS = {
        32, 40, 46, 84, 64, 95, 78, 27, 39, 39, 50, 84, 32, 36, 32, 34, 64, 64, 64, 64, 64, 64, 64, 64, 64, 64, 34, 34,
        84, 84, 84, 53, 100, 68, 69, 70, 77, 63, 58, 77, 75, 29, 29, 66, 56, 86, 75, 79, 60, 79, 69, 63, 61, 73, 68, 99,
        69, 61, 69, 39, 34, 39, 84, 50, 50, 61, 63, 55, 63, 62, 35, 63, 63, 28, 28, 58, 28, 97, 63, 61, 63, 63, 41, 52,
        39, 63, 59, 82, 59, 59, 52, 64, 34, 64, 84
    };

    /** The largest width in other alphabets, and the width of a Chinese, Japanese or Korean character. */
    private static final int OTHER = 80;

    private static final int SQUARE = 100;
    private static final double BOLD = 1.13;

    private TextSize() {}

    /** The width of one line in pixels. */
    static double width(String line, boolean bold) {
        double hundredths = line.codePoints().map(TextSize::hundredths).sum();
        return hundredths / 100 * FONT_SIZE * (bold ? BOLD : 1);
    }

    /** The width of the longest line; 0 for none. */
    static double width(List<String> lines, boolean bold) {
        return lines.stream().mapToDouble(line -> width(line, bold)).max().orElse(0);
    }

    static double height(List<String> lines) {
        return lines.size() * LINE_HEIGHT;
    }

    private static int hundredths(int codePoint) {
        if (codePoint >= ' ' && codePoint <= '~') {
            return WIDTHS[codePoint - ' '];
        }
        return isSquare(codePoint) ? SQUARE : OTHER;
    }

    private static boolean isSquare(int codePoint) {
        return codePoint >= 0x1100 && (codePoint < 0x1160 || codePoint >= 0x2E80);
    }

    /** Breaks {@code text} into lines of at most {@code width} pixels; returns no lines for an empty text. */
    static List<String> wrap(String text, double width, boolean bold) {
        List<String> lines = new ArrayList<>();
        String rest = text.strip();
        while (!rest.isEmpty()) {
            int end = fitting(rest, width, bold);
            lines.add(rest.substring(0, end).strip());
            rest = rest.substring(end).strip();
        }
        return lines;
    }

    /** How many characters of {@code text} fit on its first line; at least one. */
    private static int fitting(String text, double width, boolean bold) {
        if (width(text, bold) <= width) {
            return text.length();
        }
        int most = text.offsetByCodePoints(0, 1);
        while (most < text.length() && width(text.substring(0, text.offsetByCodePoints(most, 1)), bold) <= width) {
            most = text.offsetByCodePoints(most, 1);
        }
        for (int end = most; end > most / 3; end--) {
            if (text.charAt(end) == ' ') {
                return end;
            }
        }
        for (int end = most; end > most / 3; end--) {
            if (isSeam(text.charAt(end - 1), text.charAt(end))) {
                return end;
            }
        }
        return most;
    }

    /**
     * Whether a word may be broken between two characters: after punctuation, before a capital letter, and between wide
     * characters.
     */
    private static boolean isSeam(char before, char after) {
        return "_-.,;:/&|".indexOf(before) >= 0
                || (Character.isLowerCase(before) && Character.isUpperCase(after))
                || (isSquare(before) && isSquare(after) && !Character.isSurrogate(after));
    }
}
