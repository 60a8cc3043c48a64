package org.evoloop.xmi.dialect;

import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.zip.ZipEntry;
import java.util.zip.ZipException;
import java.util.zip.ZipFile;
import org.evoloop.statemachine.ModelException;

/** Unpacks zip files that contain one XMI document, such as ArgoUML's projects ({@code .zargo}). */
final class ZippedModel {
    private static final int NAMES_LISTED = 10;
    /** A document of this size is read in no time, however well it is packed. */
    private static final long SMALL_BYTES = 2 << 20;
    /** Real documents are packed to a tenth or a thirtieth. */
    private static final long MAX_RATIO = 100;

    private ZippedModel() {}

    /**
     * The contents of a file, or of the document in it.
     *
     * @throws ModelException if it contains several documents
     * @throws IOException if it cannot be read
     */
    static InputStream unpacked(Path file) throws IOException {
        if (!isZip(file)) {
            return Files.newInputStream(file);
        }
        ZipFile zip;
        try {
            zip = new ZipFile(file.toFile());
        } catch (ZipException damaged) {
            // The parser will report that it is not XML.
            return Files.newInputStream(file);
        }
        try {
            List<? extends ZipEntry> documents = zip.stream()
                    .filter(entry -> entry.getName().endsWith(".xmi"))
                    .toList();
            if (documents.size() > 1) {
                throw new ModelException(file + ": is a zip archive with " + documents.size() + " XMI documents in it ("
                        + String.join(
                                ", ",
                                documents.stream()
                                        .limit(NAMES_LISTED)
                                        .map(ZipEntry::getName)
                                        .toList())
                        + "); unpack it and name one");
            }
            if (documents.size() == 1) {
                ZipEntry document = documents.get(0);
                if (document.getSize() > SMALL_BYTES && document.getSize() / MAX_RATIO > document.getCompressedSize()) {
                    throw new ModelException(file + ": is a zip archive whose document " + document.getName()
                            + " would have " + (document.getSize() >> 20) + " MiB, more than " + MAX_RATIO
                            + " times its size in the archive; if it is a real model, unpack it and name the document");
                }
                return new Unpacked(zip.getInputStream(document), document.getSize(), file, zip);
            }
        } catch (IOException | RuntimeException failed) {
            zip.close();
            throw failed;
        }
        zip.close();
        return Files.newInputStream(file);
    }

    private static boolean isZip(Path file) throws IOException {
        try (InputStream bytes = Files.newInputStream(file)) {
            return bytes.read() == 'P' && bytes.read() == 'K';
        }
    }

    /** Closes the archive together with the document, which may not be longer than the archive says. */
    private static final class Unpacked extends CountedInput {
        private final Path file;
        private final ZipFile zip;
        private long left;

        Unpacked(InputStream document, long bytes, Path file, ZipFile zip) {
            super(document);
            this.left = bytes;
            this.file = file;
            this.zip = zip;
        }

        @Override
        void count(int read) {
            left -= read;
            if (left < 0) {
                throw new ModelException(
                        file + ": is a damaged zip archive, whose document is longer than it says; pack it again");
            }
        }

        @Override
        public void close() throws IOException {
            try (zip) {
                super.close();
            }
        }
    }
}
