package org.evoloop.roomba.simulator.webcam;

import java.awt.Transparency;
import java.awt.color.ColorSpace;
import java.awt.image.BufferedImage;
import java.awt.image.ComponentColorModel;
import java.awt.image.DataBuffer;
import java.awt.image.DataBufferByte;
import java.awt.image.Raster;
import java.awt.image.WritableRaster;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.UncheckedIOException;
import javax.imageio.IIOImage;
import javax.imageio.ImageIO;
import javax.imageio.ImageWriteParam;
import javax.imageio.ImageWriter;
import javax.imageio.stream.MemoryCacheImageOutputStream;
import org.evoloop.roomba.simulator.eye.CameraImage;

/**
 * Encodes pictures as JPEG.
 *
 * <p>Threading: used by one thread.
 *
 * @since 0.1
 */
public final class Jpeg implements AutoCloseable {
    /** A common setting of cheap cameras. */
    private static final float QUALITY = 0.9f;

    private static final int[] BYTE_OF_RED_GREEN_BLUE = {2, 1, 0};

    private final ImageWriter writer =
            ImageIO.getImageWritersByFormatName("jpeg").next();
    private final ImageWriteParam settings = writer.getDefaultWriteParam();
    private final ComponentColorModel colors = new ComponentColorModel(
            ColorSpace.getInstance(ColorSpace.CS_sRGB), false, false, Transparency.OPAQUE, DataBuffer.TYPE_BYTE);

    /** Creates an encoder that reuses its buffers. */
    public Jpeg() {
        settings.setCompressionMode(ImageWriteParam.MODE_EXPLICIT);
        settings.setCompressionQuality(QUALITY);
    }

    /** The picture as a JPEG file. */
    public byte[] encode(CameraImage picture) {
        int width = picture.widthPx();
        WritableRaster pixels = Raster.createInterleavedRaster(
                new DataBufferByte(picture.bgr(), picture.bgr().length),
                width,
                picture.heightPx(),
                width * 3,
                3,
                BYTE_OF_RED_GREEN_BLUE,
                null);
        ByteArrayOutputStream bytes = new ByteArrayOutputStream(picture.bgr().length / 8);
        try (MemoryCacheImageOutputStream output = new MemoryCacheImageOutputStream(bytes)) {
            writer.setOutput(output);
            writer.write(null, new IIOImage(new BufferedImage(colors, pixels, false, null), null, null), settings);
        } catch (IOException inMemory) {
            throw new UncheckedIOException(inMemory);
        }
        return bytes.toByteArray();
    }

    @Override
    public void close() {
        writer.dispose();
    }
}
