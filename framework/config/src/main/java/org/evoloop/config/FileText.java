package org.evoloop.config;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.CharBuffer;
import java.nio.charset.CharsetDecoder;
import java.nio.charset.CoderResult;
import java.nio.charset.CodingErrorAction;
import java.nio.charset.StandardCharsets;
import java.nio.file.AccessDeniedException;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.util.Locale;
import java.util.Optional;

/** Reads a small file of text as a whole. */
final class FileText {
    private static final int LARGEST = 1 << 16;

    private FileText() {}

    /**
     * Reads it.
     *
     * @return empty if it cannot be read; {@code mistakes} say why
     */
    static Optional<String> read(Path file, Mistakes mistakes) {
        if (Files.isDirectory(file)) {
            return refused(mistakes, file + ": is a directory; name a file in it");
        }
        byte[] bytes;
        try {
            bytes = FileBytes.first(LARGEST + 1, file);
        } catch (NoSuchFileException missing) {
            return refused(mistakes, file + ": does not exist; correct the path");
        } catch (AccessDeniedException denied) {
            return refused(mistakes, file + ": permission denied; let this program's user read it");
        } catch (IOException failure) {
            return refused(mistakes, file + ": cannot be read: " + failure.getMessage());
        }
        if (bytes.length > LARGEST) {
            return refused(mistakes, file + ": is larger than 64 kB, which no configuration is; correct the path");
        }
        CharsetDecoder decoder = StandardCharsets.UTF_8
                .newDecoder()
                .onMalformedInput(CodingErrorAction.REPORT)
                .onUnmappableCharacter(CodingErrorAction.REPORT);
        ByteBuffer from = ByteBuffer.wrap(bytes);
        CharBuffer text = CharBuffer.allocate(bytes.length + 1);
        CoderResult result = decoder.decode(from, text, true);
        text.flip();
        if (result.isError()) {
            mistakes.at(
                    Origin.in(file, lineAt(text, text.length())),
                    String.format(
                            Locale.ROOT,
                            "byte 0x%02X is not UTF-8; save the file in this encoding",
                            bytes[from.position()]));
            return Optional.empty();
        }
        return withoutControls(file, text, mistakes);
    }

    private static Optional<String> withoutControls(Path file, CharBuffer text, Mistakes mistakes) {
        for (int at = 0; at < text.length(); at++) {
            char each = text.charAt(at);
            if (Character.isISOControl(each) && "\t\n\r\u0085".indexOf(each) < 0) {
                mistakes.at(
                        Origin.in(file, lineAt(text, at)),
                        String.format(
                                Locale.ROOT, "the control character U+%04X is not allowed; remove it", (int) each));
                return Optional.empty();
            }
        }
        return Optional.of(text.toString());
    }

    private static int lineAt(CharSequence text, int end) {
        return 1
                + (int) text.subSequence(0, end)
                        .chars()
                        .filter(each -> each == '\n')
                        .count();
    }

    private static Optional<String> refused(Mistakes mistakes, String mistake) {
        mistakes.at(Origin.COMMAND_LINE, mistake);
        return Optional.empty();
    }
}
