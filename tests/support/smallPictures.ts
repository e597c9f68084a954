// Picture files in formats that nothing here writes. Each is 12 × 10 texels: of `texelsOfSmallPictures`, which those that are not
// lossless have only roughly. Made with @jsquash/webp 1.5 (lossless and exact; quality 80) and @jsquash/avif 2.1 (quality 70).

export const SMALL_PICTURES = {
  losslessWebp: "UklGRjwAAABXRUJQVlA4TC8AAAAvC0ACEJkyRPQ/NhHR/4CCtm2YgAh/svtDIBBIopx5rKGYvAlgUKRQFKD7Q7bEOwA=",
  lossyWebp:
    "UklGRpIAAABXRUJQVlA4WAoAAAAQAAAACwAACQAAQUxQSA0AAAABEAgk2tsPkEBE5DQKAFZQOCBeAAAAcAIAnQEqDAAKAAFAJiWwAnS3AJ4Ae4ACzOduSAD+9d3HHaq058Zy1BTNXDPmyEUHzHuqKMof62icJni+o9R61dRji7v/nMegIpPyd0N+kx45v/+tEX5O6G/9R4AAAA==",
  avif: "AAAAIGZ0eXBhdmlmAAAAAGF2aWZtaWYxbWlhZk1BMUIAAAGNbWV0YQAAAAAAAAAoaGRscgAAAAAAAAAAcGljdAAAAAAAAAAAAAAAAGxpYmF2aWYAAAAADnBpdG0AAAAAAAEAAAAsaWxvYwAAAABEAAACAAEAAAABAAABzAAAAEAAAgAAAAEAAAG1AAAAFwAAAEJpaW5mAAAAAAACAAAAGmluZmUCAAAAAAEAAGF2MDFDb2xvcgAAAAAaaW5mZQIAAAAAAgAAYXYwMUFscGhhAAAAABppcmVmAAAAAAAAAA5hdXhsAAIAAQABAAAAw2lwcnAAAACdaXBjbwAAABRpc3BlAAAAAAAAAAwAAAAKAAAAEHBpeGkAAAAAAwgICAAAAAxhdjFDgQAMAAAAABNjb2xybmNseAACAAIABoAAAAAOcGl4aQAAAAABCAAAAAxhdjFDgQAcAAAAADhhdXhDAAAAAHVybjptcGVnOm1wZWdCOmNpY3A6c3lzdGVtczphdXhpbGlhcnk6YWxwaGEAAAAAHmlwbWEAAAAAAAAAAgABBAECgwQAAgQBBYYHAAAAX21kYXQSAAoFGAzueVQyDEUwAABEsGX+49eCQBIACgkYDO55IEBA0IAyMRTAAABAALvFQ6UCCUsTGeU/zd5rRHWtvUVa3xnZ9RJl+3VTiNT1tRZDYeZuSa9tzyA=",
} as const;

export function smallPicture(name: keyof typeof SMALL_PICTURES): Uint8Array {
  return Buffer.from(SMALL_PICTURES[name], "base64");
}

/** Red left, without much of it right; more green below and more blue to the right; the lower half is half transparent. */
export function texelsOfSmallPictures(): Uint8Array {
  const [width, height] = [12, 10];
  const texels = new Uint8Array(4 * width * height);
  for (let i = 0; i < width * height; i++) {
    const [x, y] = [i % width, Math.floor(i / width)];
    texels.set([x < 6 ? 200 : 30, 20 * y, 20 * x, y < 5 ? 255 : 120], 4 * i);
  }
  return texels;
}
