import type { Plugin } from 'vite';

export declare const NOTICES_FILE: string;
export declare function thirdPartyNotices(): { worker: () => Plugin; page: Plugin };
