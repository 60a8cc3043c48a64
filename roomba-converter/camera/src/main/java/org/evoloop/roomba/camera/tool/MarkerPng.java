package org.evoloop.roomba.camera.tool;

import java.io.ByteArrayOutputStream;
import java.io.DataOutputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.zip.CRC32;
import java.util.zip.DeflaterOutputStream;
import org.evoloop.roomba.camera.MarkerSpec;

/**
 * The marker as a picture of about 300 dots per inch, with a white border of one cell, and its exact scale in the file.
 */
final class MarkerPng {
    private static final double DOTS_PER_MM = 300 / 25.4;
    private static final byte[] SIGNATURE = {(byte) 0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n'};

    private MarkerPng() {}

    static byte[] of(MarkerSpec marker) throws IOException {
        boolean[][] cells = MarkerCells.of(marker);
        int cellPx = (int) Math.max(1, Math.round(marker.sideMm() / cells.length * DOTS_PER_MM));
        int sidePx = (cells.length + 2) * cellPx;
        int pixelsPerMetre = (int) Math.round(cells.length * cellPx / (marker.sideMm() / 1000));
        ByteArrayOutputStream file = new ByteArrayOutputStream();
        DataOutputStream out = new DataOutputStream(file);
        out.write(SIGNATURE);
        // 8 bits of gray, deflated, not interlaced.
        chunk(out, "IHDR", chunk -> {
            chunk.writeInt(sidePx);
            chunk.writeInt(sidePx);
            chunk.write(new byte[] {8, 0, 0, 0, 0});
        });
        chunk(out, "pHYs", chunk -> {
            chunk.writeInt(pixelsPerMetre);
            chunk.writeInt(pixelsPerMetre);
            chunk.writeByte(1);
        });
        chunk(out, "IDAT", chunk -> {
            try (DeflaterOutputStream deflated = new DeflaterOutputStream(chunk)) {
                for (int y = 0; y < sidePx; y++) {
                    deflated.write(0);
                    for (int x = 0; x < sidePx; x++) {
                        deflated.write(isWhite(cells, y / cellPx - 1, x / cellPx - 1) ? 255 : 0);
                    }
                }
            }
        });
        chunk(out, "IEND", chunk -> {});
        return file.toByteArray();
    }

    private static boolean isWhite(boolean[][] cells, int row, int column) {
        boolean outside = row < 0 || column < 0 || row >= cells.length || column >= cells.length;
        return outside || cells[row][column];
    }

    private interface Content {
        void writeTo(DataOutputStream chunk) throws IOException;
    }

    /** Length, type, data, and a checksum of the latter two. */
    private static void chunk(DataOutputStream out, String type, Content content) throws IOException {
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        DataOutputStream chunk = new DataOutputStream(bytes);
        chunk.write(type.getBytes(StandardCharsets.US_ASCII));
        content.writeTo(chunk);
        out.writeInt(bytes.size() - type.length());
        bytes.writeTo(out);
        CRC32 checksum = new CRC32();
        checksum.update(bytes.toByteArray());
        out.writeInt((int) checksum.getValue());
    }
}
